// Names the types by which a config asks for passes and extensions.
#pragma once

#include "RangeTools.h"

#include <string>
#include <vector>

namespace Drydock
{

template<typename TFactory>
std::vector<std::string> GetFactoryTypes(const std::vector<const TFactory*>& Factories)
{
	return ToVector<std::string>(Factories, &TFactory::Type);
}

} // namespace Drydock
