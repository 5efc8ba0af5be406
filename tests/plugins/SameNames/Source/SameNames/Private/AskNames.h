// Asks everything that bears a name of drydock's effects.
#pragma once

#include "CoreMinimal.h"

class FRDGBuilder;
class FViewInfo;

/** The share of all names that are the plugin's own; 1 unless one of them is drydock's. */
float AskNames(FRDGBuilder& GraphBuilder, const FViewInfo& View);
