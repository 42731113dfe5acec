#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Taplo 0.7.0 (the TOML language server of Even Better TOML; npm, @taplo/cli): where a JSON schema tells types of table
# apart by "oneOf", a misspelled key is not named. That none of the types fits is reported instead, and not once for
# the table but at its head, at each of its keys and at each of its values: 7 errors for a table of 3 keys. With "if" and
# "then" under "allOf" the message names the key, as often.
# `gudgeon keys --schema` tells types apart by "if" and "then" (docs/decisions/0049-keys-are-declared-once.md).
# Needs: node, npm, its registry. Fails where the behaviour is another one.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit @taplo/cli@0.7.0 >/dev/null
round='{"type":"object","properties":{"type":{"const":"round"},"radius":{"type":"number"},"mass":{"type":"number"}},
  "required":["type"],"additionalProperties":false}'
flat='{"type":"object","properties":{"type":{"const":"flat"},"length":{"type":"number"},"mass":{"type":"number"}},
  "required":["type"],"additionalProperties":false}'
is_round='{"properties":{"type":{"const":"round"}}}'
is_flat='{"properties":{"type":{"const":"flat"}}}'
draft='"$schema":"http://json-schema.org/draft-07/schema#"'
echo "{$draft,\"properties\":{\"part\":{\"oneOf\":[$round,$flat]}}}" >one_of.json
echo "{$draft,\"properties\":{\"part\":{\"allOf\":[{\"if\":$is_round,\"then\":$round},{\"if\":$is_flat,\"then\":$flat}]}}}" >if_then.json
printf '[part]\ntype = "round"\nradiuss = 2.0\nmass = 1.0\n' >model.toml
for schema in one_of if_then; do
  npx taplo lint --colors never --schema "file://$folder/$schema.json" model.toml >"$schema.txt" 2>&1 || true
  errors=$(grep -c '^error:' "$schema.txt" || true)
  named=$(grep '^error:' "$schema.txt" | grep -c "'radiuss' was unexpected" || true)
  echo "$schema: $errors errors, $named of them name the key"
done | tee seen
printf 'one_of: 7 errors, 0 of them name the key\nif_then: 7 errors, 7 of them name the key\n' | diff - seen
