// Compounds that look like things of kitchens and workshops, of random size as the real things.
//
// Each stands (what is named lying: lies) upright in its body's frame or, lying on a side, is
// turned about the body's y axis, which stays horizontal. Materials are the caller's but where a
// form comes in one colour only.
#pragma once

#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::scenes {

Body Mug(Random& random);         // with a handle towards +x
Body Pitcher(Random& random);     // with a handle towards +x and a lip towards -x
Body Pan(Random& random);         // with a straight handle towards +x
Body Bottle(Random& random);      // round, with shoulder, neck, cap and often a label
Body FlatBottle(Random& random);  // of detergent or mustard
Body SprayBottle(Random& random);
Body Drill(Random& random);   // cordless, standing on its battery or lying on its side
Body Hammer(Random& random);  // lying
Body Wrench(Random& random);  // lying
Body Banana(Random& random);  // lying
Body Pear(Random& random);    // lying or standing
Body Torch(Random& random);   // lying or standing on its lamp
Body Keyboard(Random& random);
Body Plate(Random& random);
Body Slab(Random& random);   // a phone, a notebook, a bar of chocolate
Body Bag(Random& random);    // of chips or coffee, creased; lying or standing
Body Cloth(Random& random);  // folded or crumpled

// Thin things, lying.
Body Spoon(Random& random);
Body Knife(Random& random);
Body Scissors(Random& random);  // a little open
Body Screwdriver(Random& random);
Body Brush(Random& random);
Body Whisk(Random& random);

// Large things for floors.
Body Carton(Random& random);    // of cardboard or painted, often printed on
Body Backpack(Random& random);  // lying or standing
Body Slipper(Random& random);

}  // namespace fovea::scenes
