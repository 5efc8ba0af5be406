// What OwnNames.h declares: everything says 1.
#include "OwnNames.h"

#define SAME_NAMES_CLASS_BODY(Name) \
	Name::Name() = default; \
	Name::~Name() = default; \
	int32 Name::GetOwn() const \
	{ \
		return 1; \
	}

#define SAME_NAMES_PASS_BODY(Name, Inputs) \
	int32 Name(FRDGBuilder&, const FViewInfo&, const Inputs& In) \
	{ \
		return In.GetOwn(); \
	}

#define SAME_NAMES_QUESTION_BODY(Name) \
	int32 Name() \
	{ \
		return 1; \
	}

SAME_NAMES_ALL_CLASSES(SAME_NAMES_CLASS_BODY)
SAME_NAMES_ALL_PASSES(SAME_NAMES_PASS_BODY)
SAME_NAMES_ALL_QUESTIONS(SAME_NAMES_QUESTION_BODY)
