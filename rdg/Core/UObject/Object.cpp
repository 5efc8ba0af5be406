// Source: drydock.
#include "UObject/Object.h"

const FObjectInitializer& FObjectInitializer::Get()
{
	static const FObjectInitializer Initializer;
	return Initializer;
}
