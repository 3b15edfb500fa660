//! Field to table: one folder per baker; no files, no printing.
