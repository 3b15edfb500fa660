//! The obvious twin.
