// Finders of assets in constructors. There are no assets here: they find nothing, and say so. Source: engine
// UObject/ConstructorHelpers.h.
#pragma once

#include "UObject/Object.h"

struct ConstructorHelpers
{
	template<typename T>
	struct FObjectFinder
	{
		explicit FObjectFinder(const TCHAR*) {}

		bool Succeeded() const { return Object != nullptr; }

		T* Object = nullptr;
	};
};
