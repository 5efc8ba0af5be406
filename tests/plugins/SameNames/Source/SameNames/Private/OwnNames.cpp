// What OwnNames.h declares: everything says 1.
#include "OwnNames.h"

#define EFFECT_CLASS(Name) \
	Name::Name() = default; \
	Name::~Name() = default; \
	int32 Name::GetOwn() const \
	{ \
		return 1; \
	}
#define EFFECT_PASS(Name, Inputs) \
	int32 Name(FRDGBuilder&, const FViewInfo&, const Inputs& In) \
	{ \
		return In.GetOwn(); \
	}
#define EFFECT_FUNCTION(Name) \
	int32 Name() \
	{ \
		return 1; \
	}
#include "EffectNames.inl"
