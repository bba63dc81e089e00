#include "client/bundle/changed_options.h"

namespace fovea::bundle {

void ChangeOptions(const v1::DetectOptions& changes, v1::DetectOptions* options) {
  options->clear_tracking();  // there is no stream
  // Merged they would be sums of both: a list is longer then, and seconds keep their nanoseconds.
  if (changes.has_time_budget()) options->clear_time_budget();
  if (changes.has_grasps()) options->clear_grasps();
  if (changes.has_places()) options->clear_places();
  options->MergeFrom(changes);
}

}  // namespace fovea::bundle
