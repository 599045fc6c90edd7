#!/usr/bin/env bash
# count_tests.sh STATUS JUNIT.xml...: adds up what ctest wrote, names what failed or was skipped, ends with
# "N passed, N failed, N skipped". Fails when a test failed, when none ran, or when STATUS (ctest's own) is not 0.
set -euo pipefail
status=$1
shift
passed=0 failed=0 skipped=0
for file in "$@"; do
  [ -s "$file" ] || { echo "no test results in $file"; status=1; continue; }
  count() { grep -o "<testcase [^>]*status=\"$1\"" "$file" | wc -l || true; }
  names() { grep -o "<testcase [^>]*status=\"$1\"" "$file" | sed -E 's/.*name="([^"]*)".*/\1/' || true; }
  passed=$((passed + $(count run)))
  failed=$((failed + $(count fail)))
  skipped=$((skipped + $(count notrun) + $(count disabled)))
  for name in $(names fail); do echo "failed: $name"; done
  for name in $(names notrun); do echo "skipped: $name"; done
done
# ctest can fail without naming a test (a program that cannot even list its tests): that is a failure too.
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then
  echo "ctest itself failed (exit code $status)"
  failed=1
fi
[ "$passed" -gt 0 ] || { echo "no test ran"; status=1; }
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$status" -eq 0 ]
