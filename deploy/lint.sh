#!/bin/sh
# Checks the format (clang-format, black) and the code (clang-tidy, mypy) of everything that is ours.
# usage: deploy/lint.sh BUILD_FOLDER   (built, so that it holds compile_commands.json and stubs)
set -eu

build=$1
for tool in clang-format clang-tidy black mypy; do
  command -v "$tool" >/dev/null || { echo "lint: $tool is missing: apt-get install $tool" >&2; exit 1; }
done

git ls-files '*.cc' '*.h' | xargs clang-format --dry-run -Werror
# The examples build against the installed library only: tests/package does that.
git ls-files '*.cc' ':!client/examples' | xargs -P 2 -n 4 clang-tidy --quiet -p "$build"

git ls-files '*.py' | xargs black --quiet --check --line-length 100
# With the generated modules, which the sources do not have.
for what in "-p fovea" client/examples/python/clean_up.py client/examples/python/detect_once.py client/examples/python/detect_stream.py; do
  # shellcheck disable=SC2086  # a flag and its value
  MYPYPATH=$build/client/python/package mypy --config-file client/python/pyproject.toml \
    --cache-dir "$build/.mypy_cache" $what
done
