// Makes one object of each class and calls each function, from a file that knows no header of an effect.
#include "AskNames.h"
#include "OwnNames.h"

float AskNames(FRDGBuilder& GraphBuilder, const FViewInfo& View)
{
	int32 NumOwn = 0;
	int32 NumAll = 0;
#define EFFECT_CLASS(Name) NumOwn += TUniquePtr<Name>(new Name)->GetOwn(), ++NumAll;
#define EFFECT_PASS(Name, Inputs) NumOwn += Name(GraphBuilder, View, Inputs()), ++NumAll;
#define EFFECT_FUNCTION(Name) NumOwn += Name(), ++NumAll;
#include "EffectNames.inl"
	return static_cast<float>(NumOwn) / static_cast<float>(NumAll);
}
