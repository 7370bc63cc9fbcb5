#!/usr/bin/env bash
# Usage: run_page_test.sh WRITE_EXAMPLE_PAGE WORK_FOLDER. Status 77: skipped, because Chromium or Node is not installed.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
writer=$1 work=$2
for program in node npm chromium; do
  command -v "$program" >/dev/null || { echo "SKIPPED: $program is not installed (apt-get install chromium nodejs npm)"; exit 77; }
done
mkdir -p "$work/pages"
cp "$here"/*.js "$here"/package.json "$here"/package-lock.json "$work/"
# Node looks for packages beside the test, so both stand in the build folder.
if ! cmp -s "$here/package-lock.json" "$work/installed-lock.json"; then
  (cd "$work" && npm ci --no-audit --no-fund --loglevel=error)
  cp "$here/package-lock.json" "$work/installed-lock.json"
fi
"$writer" "$work/pages"
exec node "$work/report_page_test.js" "$work/pages"
