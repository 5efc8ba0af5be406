// Names the types by which a config asks for passes and extensions.
#pragma once

#include <string>
#include <vector>

namespace Drydock
{

template<typename TFactory>
std::vector<std::string> GetFactoryTypes(const std::vector<const TFactory*>& Factories)
{
	std::vector<std::string> Types;
	for (const TFactory* Factory : Factories)
	{
		Types.push_back(Factory->Type);
	}
	return Types;
}

} // namespace Drydock
