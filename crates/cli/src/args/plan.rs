//! What may be typed after `barchan plan`.

use clap::Args;

use super::WantedArguments;

#[derive(Debug, Args)]
#[command(
    after_help = "Nothing is baked or written, and no height map and no mesh is read: sizes that only they can say are left \
open. A recipe is refused as `bake` would refuse it, as far as that can be seen without them.

Examples:
  barchan plan samples/dunes.ron
  barchan plan rock.png --only height,hemisphere,cone_map
  barchan plan samples/dunes.ron --json | jq .tables[].decision"
)]
pub(crate) struct PlanArguments {
    #[command(flatten)]
    pub(crate) wanted: WantedArguments,
}
