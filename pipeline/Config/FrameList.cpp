// Reads a list of frames such as 1-9x2.
#include "Config/FrameList.h"

#include "TextTools.h"

#include <charconv>
#include <string_view>

namespace Drydock
{

namespace
{

/** More is a slip of the finger; it would only be found out frame by frame. */
constexpr int MaxFrames = 100000;

/** A whole number from 0 at the beginning of Text, which it is taken from. */
std::optional<int> TakeNumber(std::string_view& Text)
{
	int Number = 0;
	const std::from_chars_result Result = std::from_chars(Text.data(), Text.data() + Text.size(), Number);
	if (Result.ec != std::errc() || Text.front() == '-')
	{
		return std::nullopt;
	}
	Text.remove_prefix(static_cast<size_t>(Result.ptr - Text.data()));
	return Number;
}

bool TakeMark(std::string_view& Text, char Mark)
{
	const bool bFound = !Text.empty() && Text.front() == Mark;
	Text.remove_prefix(bFound ? 1 : 0);
	return bFound;
}

std::optional<FFrameRange> ParseRange(std::string_view Part, std::string& OutError)
{
	const std::string Name(Part);
	const std::optional<int> First = TakeNumber(Part);
	const bool bRange = First && TakeMark(Part, '-');
	const std::optional<int> Last = bRange ? TakeNumber(Part) : First;
	const bool bStep = bRange && Last && TakeMark(Part, 'x');
	const std::optional<int> Step = bStep ? TakeNumber(Part) : 1;
	if (!First || !Last || !Step || !Part.empty())
	{
		OutError = "\"" + Name + "\" is not a frame or a range of frames: expected all, 1-8, 1-9x2 or 1,3,5-8";
		return std::nullopt;
	}
	if (*Last < *First || *Step < 1)
	{
		OutError =
			*Step < 1 ? "the step of \"" + Name + "\" must be 1 at least" : "\"" + Name + "\" ends before it begins";
		return std::nullopt;
	}
	return FFrameRange{*First, *Last, *Step};
}

} // namespace

std::optional<FFrameList> ParseFrameList(const std::string& Text, std::string& OutError)
{
	if (Text == "all")
	{
		return FFrameList{true, {}};
	}
	FFrameList List;
	int NumFrames = 0;
	for (const std::string& Part : SplitText(Text + ",", ','))
	{
		const std::optional<FFrameRange> Range = ParseRange(Part, OutError);
		if (!Range)
		{
			return std::nullopt;
		}
		if (!List.Ranges.empty() && Range->First <= List.Ranges.back().Last)
		{
			OutError = "frame " + std::to_string(Range->First) + " comes after " +
					   std::to_string(List.Ranges.back().Last) + ": frames are rendered in ascending order, each once";
			return std::nullopt;
		}
		if ((Range->Last - Range->First) / Range->Step >= MaxFrames - NumFrames)
		{
			OutError = "\"" + Text + "\" is more than " + std::to_string(MaxFrames) + " frames";
			return std::nullopt;
		}
		NumFrames += (Range->Last - Range->First) / Range->Step + 1;
		List.Ranges.push_back(*Range);
	}
	return List;
}

std::string FormatFrameList(const std::vector<int>& Frames)
{
	std::string Text;
	for (size_t Index = 0; Index < Frames.size();)
	{
		const int Step = Index + 1 < Frames.size() ? Frames[Index + 1] - Frames[Index] : 1;
		size_t Last = Index;
		while (Last + 1 < Frames.size() && Frames[Last + 1] - Frames[Last] == Step)
		{
			++Last;
		}
		Last = Step > 1 && Last == Index + 1 ? Index : Last; // two numbers are shorter than a step
		Text += (Text.empty() ? "" : ",") + std::to_string(Frames[Index]);
		if (Last > Index)
		{
			Text += "-" + std::to_string(Frames[Last]) + (Step > 1 ? "x" + std::to_string(Step) : "");
		}
		Index = Last + 1;
	}
	return Text;
}

std::vector<int> ListFrames(const FFrameList& List, const std::vector<int>& Existing)
{
	if (List.bAll)
	{
		return Existing;
	}
	std::vector<int> Frames;
	for (const FFrameRange& Range : List.Ranges)
	{
		// By count: Last may be the greatest number there is.
		for (int Index = 0; Index <= (Range.Last - Range.First) / Range.Step; ++Index)
		{
			Frames.push_back(Range.First + Index * Range.Step);
		}
	}
	return Frames;
}

} // namespace Drydock
