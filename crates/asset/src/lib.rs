//! The .barchan file: sections to bytes and back, and typed views of each table kind.
