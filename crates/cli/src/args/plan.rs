//! What may be typed after `barchan plan`.

use clap::Args;

use super::WantedArguments;

#[derive(Debug, Args)]
#[command(
    after_help = "Nothing is baked or written, and nothing is read but the recipe: sizes that only a height map or a mesh says are \
left open. A recipe is refused as `bake` would refuse it, as far as that can be seen without its inputs.

Examples:
  barchan plan samples/dunes.ron
  barchan plan rock.png --only height,hemisphere,cone_map
  barchan plan samples/dunes.ron --json | jq .tables[].decision"
)]
pub(crate) struct PlanArguments {
    #[command(flatten)]
    pub(crate) wanted: WantedArguments,
}
