#!/usr/bin/env bash
# Scripts/demo once more: it must come back with pictures, masks, error maps and a table, and leave what was
# installed and built alone.
set -uo pipefail
root=$1
failures=0

check() { # what got expected
  if [[ "$2" == "$3" ]]; then
    echo "  ok   $1: got $2"
  else
    echo "  FAIL $1: got $2, expected $3"
    failures=$((failures + 1))
  fi
}

for script in "$root"/Scripts/* "$root/.ci/run"; do
  bash -n "$script"
  check "syntax of ${script#"$root"/}" $? 0
done

built=$(stat -c %Y "$root/build/bin/vtkshadows")
rm -rf "$root/demo-output"
log=$("$root/Scripts/demo" 2>&1)
check "status of Scripts/demo" $? 0
check "time of the command's last build" "$(stat -c %Y "$root/build/bin/vtkshadows")" "$built"
for name in unshadowed {depth-map,stencil-volume,ray-cast}{,-visibility-0,-error-0}; do
  check "$name.png is a PNG" "$(head -c 4 "$root/demo-output/$name.png" | tail -c 3)" PNG
done
for technique in depth-map stencil-volume ray-cast; do
  check "rows of $technique in the table" "$(grep -c "^$technique " <<< "$log")" 1
done

((failures == 0)) || { echo "$log"; exit 1; }
