// Asks the terminal for its size; wraps lines.
#include "Text/Terminal.h"

#include "TextTools.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sys/ioctl.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

/** The end of the escape sequence at Begin; Begin if there is none. */
size_t SkipEscape(const std::string& Text, size_t Begin)
{
	if (Text[Begin] != '\x1b')
	{
		return Begin;
	}
	const size_t End = Text.find('m', Begin);
	return End == std::string::npos ? Text.size() : End + 1;
}

/** Bytes from Begin on that fill Columns columns, escape sequences behind them included. */
size_t CountBytes(const std::string& Text, size_t Begin, size_t Columns)
{
	size_t At = Begin;
	for (size_t Seen = 0; At < Text.size();)
	{
		const size_t Behind = SkipEscape(Text, At);
		if (Behind != At)
		{
			At = Behind;
			continue;
		}
		const bool bContinues = (static_cast<unsigned char>(Text[At]) & 0xC0) == 0x80;
		if (!bContinues && Seen++ == Columns)
		{
			break;
		}
		++At;
	}
	return At - Begin;
}

/** The column at which the text of a line begins: behind blanks, and behind a label that two blanks end. */
size_t FindIndent(const std::string& Line, size_t Width)
{
	constexpr size_t Deeper = 2;
	constexpr size_t Deep = 12; // a line that goes on already
	const size_t Begin = std::min(Line.find_first_not_of(' '), Line.size());
	const size_t Gap = Line.find("  ", Begin);
	const size_t Behind = Gap == std::string::npos ? Gap : Line.find_first_not_of(' ', Gap);
	const size_t Label = Behind == std::string::npos ? Width : CountColumns(Line.substr(0, Behind));
	return std::min(Label <= Width / 2 ? Label : Begin < Deep ? Begin + Deeper : Begin, Width / 2);
}

std::string FitLine(const std::string& Line, size_t Width)
{
	if (CountColumns(Line) <= Width)
	{
		return Line + "\n";
	}
	const size_t Indent = FindIndent(Line, Width);
	std::string Fitted;
	for (size_t Begin = 0; Begin < Line.size();)
	{
		const size_t Taken = Begin == 0 ? 0 : Indent; // by the blanks before it
		size_t End = Begin + CountBytes(Line, Begin, Width - Taken);
		size_t Next = End;
		if (End < Line.size())
		{
			const size_t Blank = Line.rfind(' ', End);
			const size_t Least = Begin == 0 ? Indent : Begin; // a break among the first blanks would gain nothing
			if (Blank != std::string::npos && Blank > Least)
			{
				End = Line.find_last_not_of(' ', Blank) + 1;
				Next = Line.find_first_not_of(' ', Blank);
			}
		}
		Fitted += std::string(Taken, ' ') + Line.substr(Begin, End - Begin) + "\n";
		Begin = std::min(Next, Line.size());
	}
	return Fitted;
}

} // namespace

int GetTerminalWidth(int FileDescriptor)
{
	constexpr int Least = 40;
	constexpr int Otherwise = 80;
	if (isatty(FileDescriptor) == 0)
	{
		return 0;
	}
	if (const char* const Said = std::getenv("COLUMNS"))
	{
		if (const std::optional<int> Columns = ParseAll<int>(Said); Columns > 0)
		{
			return std::max(*Columns, Least);
		}
	}
	winsize Size = {};
	const bool bKnown = ioctl(FileDescriptor, TIOCGWINSZ, &Size) == 0 && Size.ws_col > 0;
	return std::max(bKnown ? static_cast<int>(Size.ws_col) : Otherwise, Least);
}

size_t CountColumns(const std::string& Text)
{
	size_t Count = 0;
	for (size_t At = 0; At < Text.size();)
	{
		const size_t Behind = SkipEscape(Text, At);
		if (Behind != At)
		{
			At = Behind;
			continue;
		}
		Count += (static_cast<unsigned char>(Text[At]) & 0xC0) != 0x80;
		++At;
	}
	return Count;
}

std::string FitLines(const std::string& Text, int Width)
{
	if (Width <= 0)
	{
		return Text;
	}
	std::string Fitted;
	for (const std::string& Line : SplitText(Text))
	{
		Fitted += FitLine(Line, static_cast<size_t>(Width));
	}
	if (!Fitted.empty() && Text.back() != '\n')
	{
		Fitted.pop_back();
	}
	return Fitted;
}

} // namespace Drydock
