// Holds the one initializer that the constructors of objects are given.
#include "UObject/Object.h"

const FObjectInitializer& FObjectInitializer::Get()
{
	static const FObjectInitializer Initializer;
	return Initializer;
}
