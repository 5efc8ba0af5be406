#!/usr/bin/env bash
# The pages in real browsers: lets drydock write one of each kind and serve the live one, then runs the tests beside this script.
#   report/test/RunBrowserTests.sh BUILD SOURCE WORK [long]
# With "long" it runs what the suite leaves out: tests of the live page that take minutes.
# Exit code 77 where node, its modules (npm ci in report/), oiiotool or Chromium are not there.
set -euo pipefail
Drydock=$1/bin/drydock Source=$2 Work=$3

Skip() { echo "skipped: $*"; exit 77; }
command -v node >/dev/null || Skip "there is no node"
[ -d "$Source/report/node_modules/playwright-core" ] || Skip "no modules: npm ci in report/"
command -v oiiotool >/dev/null || Skip "there is no oiiotool (openimageio-tools)"
CHROMIUM=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || Skip "there is no Chromium: apt-get install chromium"

rm -rf "$Work" && mkdir -p "$Work"
MakePages() {
	local Config=$Source/configs/toon_bloom.json Pair=("$Work/strong" "$Work/weak")
	"$Drydock" run "$Config" --out "$Work/plain" >/dev/null
	"$Drydock" run "$Config" --out "$Work/plain" --pp BloomIntensity=3 --report on >/dev/null
	"$Drydock" run "$Config" --out "$Work/full" --dump ToonBloomMask --dump BloomSetup --report full >/dev/null
	"$Drydock" study "$Source/configs/study_bloom_quality.json" --out "$Work/study" --report >/dev/null
	"$Drydock" run "$Config" --out "${Pair[0]}" --pp BloomIntensity=3 --dump BloomSetup --fingerprints >/dev/null
	"$Drydock" run "$Config" --out "${Pair[1]}" --dump BloomSetup --fingerprints >/dev/null
	"$Drydock" diff "${Pair[@]}" --out "$Work/diff" --report >/dev/null
	"$Drydock" run "$Source/configs/volumes_walk.json" --frames all --out "$Work/walk" --report >/dev/null
	"$Drydock" run "$Source/configs/volumes_walk.json" --frame 4 --out "$Work/walk4" --report >/dev/null
	"$Drydock" matrix "$Source/tests/plugins/ShowUV" --versions 5.4-5.5 --out "$Work/matrix" --report >/dev/null
}
if [ "${4:-}" = long ]; then
	export REPORT_LONG=1
else
	MakePages
fi
DRYDOCK=$(realpath "$Drydock") SOURCE=$(realpath "$Source")
export CHROMIUM REPORT_RUNS=$Work DRYDOCK SOURCE
cd "$Source/report"
coproc Server { exec node test/serve.mjs; }
trap 'kill "$Server_PID"' EXIT
read -r BROWSER <&"${Server[0]}"
export BROWSER
node --test --test-concurrency=3 --test-reporter=spec test/${REPORT_LONG:+live}*.test.mjs
