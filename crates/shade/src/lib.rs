//! The run-time equations on the CPU, one file per technique, and the plain baselines beside them.
