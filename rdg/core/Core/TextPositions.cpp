// Counts the lines and columns of offsets in a text.
#include "TextPositions.h"

#include <algorithm>

namespace Drydock
{

FTextPositions::FTextPositions(const std::string& InText)
	: Text(InText)
{
	LineBegins.push_back(0);
	for (size_t At = 0; At < Text.size(); ++At)
	{
		if (Text[At] == '\n')
		{
			LineBegins.push_back(At + 1);
		}
	}
	LastOffset = Text.starts_with("\xEF\xBB\xBF") ? 3 : 0; // a byte-order mark has no column
	LineBegins[0] = LastOffset;
}

FTextPosition FTextPositions::Find(size_t Offset) const
{
	Offset = std::clamp(Offset, LineBegins[0], Text.size());
	const auto Line = std::upper_bound(LineBegins.begin(), LineBegins.end(), Offset) - LineBegins.begin();
	if (Line != Last.Line || Offset < LastOffset)
	{
		Last = {static_cast<int>(Line), 1};
		LastOffset = LineBegins[static_cast<size_t>(Line) - 1];
	}
	const auto IsFirstByte = [](char Character)
	{
		return (static_cast<unsigned char>(Character) & 0xC0) != 0x80;
	};
	using FDistance = std::string::difference_type;
	Last.Column += static_cast<int>(std::count_if(
		Text.begin() + static_cast<FDistance>(LastOffset), Text.begin() + static_cast<FDistance>(Offset), IsFirstByte));
	LastOffset = Offset;
	return Last;
}

} // namespace Drydock
