#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: with.sh PROGRAM… -- COMMAND…: runs the command, or says which program is missing and ends
# with 77, which CTest takes for skipped.
while [ "$1" != -- ]; do
  command -v "$1" >/dev/null || { echo "skipped: no $1 (cmake/packages-tests.txt)"; exit 77; }
  shift
done
shift
exec "$@"
