#!/usr/bin/env bash
# report/page.html and report/live.html are what report/src gives, and the sources have no type errors.
#   report/test/CheckBundle.sh SOURCE
# Exit code 77 where node or its modules are not there.
set -euo pipefail
cd "$1/report"
command -v node >/dev/null || { echo "skipped: there is no node"; exit 77; }
[ -d node_modules/esbuild ] || { echo "skipped: no modules: npm ci in report/"; exit 77; }
node node_modules/typescript/bin/tsc
exec node build.mjs --check
