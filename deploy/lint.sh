#!/bin/sh
# Checks the format of everything that is ours (clang-format, black) and the code: C++ with
# clang-tidy, Python with mypy, shell with shellcheck, CMake with cmake-lint, the observer's page with
# TypeScript.
# usage: deploy/lint.sh BUILD_FOLDER [--quick [BASE]]
# BUILD_FOLDER is built, so that it holds compile_commands.json and stubs. --quick: clang-tidy only of
# sources that changed since they parted from BASE (main unless given), of 20 at most.
set -eu

build=$1
quick=${2:-}
base=${3:-main}

deploy/install_dependencies.sh clang-format clang-tidy black mypy shellcheck cmake-format

git ls-files '*.cc' '*.h' | xargs clang-format --dry-run -Werror
git ls-files '*.py' | xargs black --quiet --check --line-length 100

# With and without an ending.
git grep -lE '^#!/(bin/sh|bin/bash|usr/bin/env bash)$' | xargs shellcheck --severity=warning
git ls-files '*CMakeLists.txt' '*.cmake' | xargs cmake-lint --suppress-decorations

# The examples build against the installed library only: tests/package does that. Clang 14 does not
# know the coroutines of GCC's library, which http_server.cc has, and what its sending is tested with.
set -- ':!client/examples' ':!client/observer/http_server.cc' ':!tests/observer/http_sending_test.cc'
sources=$(git ls-files '*.cc' "$@")
if [ "$quick" = --quick ]; then
  since=$(git merge-base HEAD "$base" 2>/dev/null || git merge-base HEAD "origin/$base" 2>/dev/null || true)
  sources=""
  [ -z "$since" ] || sources=$(git diff --name-only --diff-filter=d "$since" -- '*.cc' "$@")
  [ "$(echo "$sources" | wc -l)" -le 20 ] || { echo "lint: clang-tidy of 20 of the sources that changed"; sources=$(echo "$sources" | head -n 20); }
fi
# Each source on its own and without the headers that GCC compiled before, which clang cannot read: so
# it also sees what a file forgot to include. What is generated is taken from BUILD_FOLDER.
if [ -n "$sources" ]; then
  cmake -S . -B "$build/tidy" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -D FOVEA_UNITY=OFF -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
  # Nor does it know what is said of GCC's garbage.
  sed -i -e "s#$build/tidy/#$build/#g" -e "s# --param=[^ ]*##g" "$build/tidy/compile_commands.json"
  echo "$sources" | xargs -P 2 -n 4 clang-tidy --quiet -p "$build/tidy"
fi

# With the generated modules, which the sources do not have.
for what in "-p fovea" client/examples/python/clean_up.py client/examples/python/detect_once.py client/examples/python/detect_stream.py; do
  # shellcheck disable=SC2086  # a flag and its value
  MYPYPATH=$build/client/python/package mypy --config-file client/python/pyproject.toml \
    --cache-dir "$build/.mypy_cache" $what
done

deploy/check_page.sh
