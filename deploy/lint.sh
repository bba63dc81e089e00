#!/bin/sh
# Checks the format (clang-format) and the code (clang-tidy) of everything that is ours.
# usage: deploy/lint.sh BUILD_FOLDER   (configured, so that it holds compile_commands.json)
set -eu

build=$1
for tool in clang-format clang-tidy; do
  command -v "$tool" >/dev/null || { echo "lint: $tool is missing: apt-get install $tool" >&2; exit 1; }
done

git ls-files '*.cc' '*.h' | xargs clang-format --dry-run -Werror
git ls-files '*.cc' | xargs -P 2 -n 4 clang-tidy --quiet -p "$build"
