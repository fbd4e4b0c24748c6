// Drawing from an alias table (Walker 1977) with two 32-bit integers: one picks a slot, the other
// decides between the slot's own entry and its alias. scene/alias_table builds the tables.
#ifndef HM_SHADING_LIGHT_ALIAS_H
#define HM_SHADING_LIGHT_ALIAS_H

#include "shading/structs.h"

HM_NAMESPACE_BEGIN

struct AliasDraw {
    uint index;
    float pdf;  // probability of the index
};

// The slot that `choice` picks from a table of `count` entries.
HM_FN uint alias_slot(uint choice, uint count) {
    return mul_high(choice, count);
}

// `entry` is the table's entry at `slot`.
HM_FN void draw_alias(uint slot, HM_IN(AliasEntry) entry, uint coin, HM_OUT(AliasDraw) drawn) {
    bool own = coin < entry.threshold;
    drawn.index = own ? slot : entry.alias;
    drawn.pdf = own ? entry.pdf_self : entry.pdf_alias;
}

HM_NAMESPACE_END

#endif
