// Names kinds of outputs.
#include "Config/OutputKinds.h"

#include "RangeTools.h"

namespace Drydock
{

const std::vector<std::string>& GetOutputKindNames()
{
	static const std::vector<std::string> Names = {"png", "exr", "json", "dot"};
	return Names;
}

FOutputKinds MakeOutputKinds(const std::vector<std::string>& Names)
{
	const std::vector<std::string>& Known = GetOutputKindNames();
	FOutputKinds Kinds;
	for (size_t Index = 0; Index < Known.size(); ++Index)
	{
		if (Contains(Names, Known[Index]))
		{
			Kinds.insert(static_cast<EOutputKind>(Index));
		}
	}
	return Kinds;
}

FOutputKinds GetAllOutputKinds()
{
	return MakeOutputKinds(GetOutputKindNames());
}

} // namespace Drydock
