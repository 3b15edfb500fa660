//! Error between fields and between pictures: RMS, maximum, where it is worst, false colour.
