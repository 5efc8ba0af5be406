// Texts that hold for several versions, each with the versions it holds for.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace Drydock
{

struct FVersionGroup
{
	std::string Text;
	std::vector<int> Minors; // ascending where they were added so
};

class FVersionGroups
{
public:
	void Add(const std::string& Text, int Minor)
	{
		const auto Known = std::ranges::find(Groups, Text, &FVersionGroup::Text);
		if (Known == Groups.end())
		{
			Groups.push_back({Text, {Minor}});
		}
		else if (Known->Minors.back() != Minor)
		{
			Known->Minors.push_back(Minor);
		}
	}

	/** In the order in which their texts came up. */
	const std::vector<FVersionGroup>& Get() const { return Groups; }

private:
	std::vector<FVersionGroup> Groups;
};

} // namespace Drydock
