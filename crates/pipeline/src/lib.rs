//! A recipe to a plan to an asset.
