// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program of the page, compiled for this machine: page_program. Each line of the standard input is a question,
// "segment WORDS", "write REQUEST", "example SHAPE FACES" or "about", as in web/program.h; each line of the output is its answer.

#include "program.h"

#include <iostream>
#include <sstream>
#include <string>

void page_progress(double, const char*, int) {}

void page_warning(const char* warning)
{
  std::cerr << warning << std::endl;
}

int main()
{
  std::string line;
  while (std::getline(std::cin, line))
  {
    std::istringstream words(line);
    std::string question, shape;
    int faces = 0;
    words >> question >> std::ws;
    if (question == "example")
    {
      words >> shape >> faces;
      std::cout << page_make_example(shape.c_str(), faces) << std::endl;
      continue;
    }
    std::string text;
    std::getline(words, text);
    std::cout << (question == "segment" ? page_segment(text.c_str())
                  : question == "write" ? page_write(text.c_str())
                                        : page_about())
              << std::endl;
  }
}
