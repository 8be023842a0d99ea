#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
# Puts tools/pre-commit where git looks for hooks; keeps another hook that is already there.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
hooks=$(git rev-parse --git-path hooks)
hook=$hooks/pre-commit
if [[ -e $hook ]] && ! cmp -s tools/pre-commit "$hook" && ! grep -q 'cmake --build build --target hooks' "$hook"; then
  echo "$hook is somebody else's: left as it is" >&2
  exit 1
fi
mkdir -p "$hooks"
cp tools/pre-commit "$hook"
chmod +x "$hook"
echo "installed $hook"
