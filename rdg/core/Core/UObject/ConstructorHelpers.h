// Defines the finders of assets in constructors. There are no assets here: the finders find nothing, and report this.
// Source: engine UObject/ConstructorHelpers.h.
#pragma once

#include "UObject/Object.h"

struct ConstructorHelpers
{
	template<typename T>
	struct FObjectFinder
	{
		explicit FObjectFinder(const TCHAR* Path)
			: Object(LoadObject<T>(nullptr, Path))
		{
		}

		bool Succeeded() const { return Object != nullptr; }

		T* Object = nullptr;
	};
};
