# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For scripts that unpack packages of Debian into a folder, from the archive that this machine's own apt sources name. Nothing is
# installed, and neither the sources nor the package lists of the machine change. Read by them with `.`; they have a
# function `fail`.

# release_of_machine: its code name
release_of_machine()
{
  (. /etc/os-release && echo "$VERSION_CODENAME")
}

# use_archive KIND SUITE FOLDER: makes FOLDER, where in_archive works then. KIND is deb or deb-src.
use_archive()
{
  command -v apt-get > /dev/null || fail "needs apt-get"
  # An entry of the sources may name the release by its suite or by its code name.
  uri=$(apt-get indextargets --format '$(COMPONENT) $(REPO_URI) $(RELEASE) $(CODENAME)' \
        | awk -v release="$(release_of_machine)" '$1 == "main" && ($3 == release || $4 == release) { print $2; exit }')
  [ -n "$uri" ] || fail "the apt sources of this machine name no Debian archive"
  apt_folder=$3
  mkdir -p "$apt_folder/lists/partial" "$apt_folder/cache/archives/partial"
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  signed=
  [ ! -f "$keyring" ] || signed="[signed-by=$keyring]"
  echo "$1 $signed $uri $2 main" > "$apt_folder/sources.list"
  in_archive update || fail "cannot read the package lists of $2 from $uri"
}

# in_archive WORD...: apt-get in that folder; what is downloaded is there
in_archive()
{
  (cd "$apt_folder" && apt-get -q -o Dir::Etc::sourcelist="$apt_folder/sources.list" -o Dir::Etc::sourceparts=- \
    -o Dir::State::Lists="$apt_folder/lists" -o Dir::Cache="$apt_folder/cache" -o APT::Sandbox::User=root "$@" >&2)
}
