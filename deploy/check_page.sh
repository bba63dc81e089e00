#!/bin/sh
# Builds the page of fovea-observer from its sources and what its lock file names, and compares that
# with what is kept: the program is built of the latter, without npm. Says so where there is no npm.
# usage: deploy/check_page.sh
set -eu
page=client/observer/page

if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
  echo "check_page: SKIPPED: npm is not installed, so nobody knows whether $page/dist is up to date" >&2
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$page/src" "$page/build.mjs" "$page/package.json" "$page/package-lock.json" "$page/tsconfig.json" "$work/"
(cd "$work" && npm ci --silent --no-audit --no-fund && npx tsc --noEmit && node build.mjs)
if ! diff -rq "$work/dist" "$page/dist"; then
  echo "check_page: $page/dist is not what its sources make: cd $page && npm ci && npm run build" >&2
  exit 1
fi
