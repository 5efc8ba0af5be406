// Classes and functions of the plugin's own, in the global namespace, under all names that drydock's effects have:
// those of the engine and of the articles among them. EffectNames.inl lists them; it is made from the tree.
#pragma once

#include "CoreMinimal.h"

class FRDGBuilder;
class FViewInfo;

/** A class that says 1 when it is the one defined here, with more in it than drydock's of that name. */
#define EFFECT_CLASS(Name) \
	class Name \
	{ \
	public: \
		Name(); \
		virtual ~Name(); \
		virtual int32 GetOwn() const; \
		double Padding[64] = {}; \
	};
#define EFFECT_PASS(Name, Inputs)
#define EFFECT_FUNCTION(Name)
#include "EffectNames.inl"
#undef EFFECT_CLASS
#undef EFFECT_PASS
#undef EFFECT_FUNCTION

/** Passes with drydock's arguments: they say 1 as well, and add nothing. Other functions have no arguments. */
#define EFFECT_CLASS(Name)
#define EFFECT_PASS(Name, Inputs) int32 Name(FRDGBuilder& GraphBuilder, const FViewInfo& View, const Inputs& In);
#define EFFECT_FUNCTION(Name) int32 Name();
#include "EffectNames.inl"
#undef EFFECT_CLASS
#undef EFFECT_PASS
#undef EFFECT_FUNCTION
