#!/usr/bin/env bash
# take_screenshots.sh: takes the pictures of reports in this folder. Needs chromium.
# They show the synthetic pulse of the tours: pictures of recorded motions may not be given away.
set -euo pipefail

images=$(cd -- "$(dirname -- "$0")" && pwd)
checkout=$(dirname -- "$(dirname -- "$images")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# picture NAME TOUR OPTION...: the top of a tour's report at its third impact, 1100 x 1500 pixels.
picture() {
  local page=$folder/$1/report.html
  "$checkout/moat" run "$checkout/examples/$2" --out "$folder/$1" --quiet "${@:3}"
  cat >>"$page" <<'END'
<script>addEventListener("load", () => {
  const next = [...document.querySelectorAll("button")].find((button) => button.textContent === "Next impact");
  for (let i = 0; i < 3; ++i) next.click();
});</script>
END
  chromium --headless=new --no-sandbox --disable-gpu --hide-scrollbars --virtual-time-budget=4000 \
    --window-size=1100,1500 --screenshot="$images/$1.png" "file://$page" 2>/dev/null
}

picture report_line 01_moat_wall.cpp --end "8 s"
picture report_plan 05_plan.cpp --end "8 s" --check
