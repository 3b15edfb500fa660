//! PNG, EXR, TIFF and NPY files into fields; every convention is decided here.
