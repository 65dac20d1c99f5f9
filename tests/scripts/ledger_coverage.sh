#!/usr/bin/env bash
# ledger_coverage.sh LEDGER REPORT [COLUMNS]: every owed statement has its record and its control, in each of
# these columns, or, without COLUMNS, in all that were run.
set -euo pipefail
"$1" merge "$2"
"$1" verify "$2" ${3:+--scalars "$3"}
