// Things of kitchens, workshops and desks, most of them not convex.
#pragma once

#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::scenes {

// One of the forms of household_forms.h or, two times in five, an object of random_objects.h, on
// z = 0 around the origin.
Body RandomHouseholdObject(Random& random);

// The same with those forms that are soft, flat or small.
Body RandomSupply(Random& random);

// Most of them thin: cutlery, scissors, tools, plates.
Body RandomTool(Random& random);

// Cartons, backpacks and slippers, without the small solids.
Body RandomLuggage(Random& random);

}  // namespace fovea::scenes
