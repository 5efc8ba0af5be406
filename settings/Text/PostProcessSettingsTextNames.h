// Names of keys and classes that the reader and the writer of settings share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace Drydock
{

/** The one field of FPostProcessSettings that is not in the table. */
inline constexpr const char* BlendablesName = "WeightedBlendables";

/** Names with the place of the first one; the text lists twenty of them. */
class FSettingNameList
{
public:
	static constexpr size_t MaxListed = 20;

	void Add(const std::string& Name, size_t InOffset)
	{
		Offset = Num == 0 ? InOffset : std::min(Offset, InOffset);
		if (Num++ < MaxListed)
		{
			Text += std::string(Text.empty() ? "" : ", ") + Name;
		}
	}
	size_t GetNum() const { return Num; }
	size_t GetOffset() const { return Offset; }
	std::string GetText() const
	{
		return Text + (Num > MaxListed ? " and " + std::to_string(Num - MaxListed) + " more" : "");
	}

private:
	std::string Text;
	size_t Num = 0;
	size_t Offset = 0;
};

} // namespace Drydock
