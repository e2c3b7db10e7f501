// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// replay FOLDER...: runs a fuzz target on all files of the folders.

#include "fuzz_target.h"

#include <filesystem>
#include <fstream>
#include <iterator>

int main(int argc, char** argv)
{
  std::size_t number_of_files = 0;
  for (int i = 1; i < argc; ++i)
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
    {
      std::ifstream in(entry.path(), std::ios::binary);
      std::cout << entry.path().filename().string() << std::endl; // the last one is the culprit
      fuzz(std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()));
      ++number_of_files;
    }
  std::cout << number_of_files << " files" << std::endl;
  return number_of_files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
