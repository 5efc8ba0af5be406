// Shares the width of a terminal among the columns of a table.
#include "Text/TextTable.h"

#include "PrintText.h"
#include "Text/Terminal.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr size_t Gap = 2;
constexpr size_t LeastName = 16;
constexpr size_t LeastText = 24; // unless all its words are shorter
constexpr size_t LeastOfAll = 8;

/** Widths of one column, in characters. */
struct FWidths
{
	size_t Least = 0;
	size_t Natural = 0;
	size_t Given = 0;
};

size_t CountLongestWord(const std::string& Text)
{
	size_t Longest = 0;
	for (const std::string& Word : SplitText(Text, ' '))
	{
		Longest = std::max(Longest, CountColumns(Word));
	}
	return Longest;
}

FWidths Measure(const FTextTable& Table, size_t Column)
{
	FWidths Widths;
	size_t LongestWord = 0;
	for (const std::vector<std::string>& Row : Table.Rows)
	{
		Widths.Natural = std::max(Widths.Natural, CountColumns(Row[Column]));
		LongestWord = std::max(LongestWord, CountLongestWord(Row[Column]));
	}
	const ETextColumn Kind = Table.Columns[Column].Kind;
	Widths.Least = Kind == ETextColumn::Number ? Widths.Natural
				   : Kind == ETextColumn::Name ? std::min(Widths.Natural, LeastName)
											   : std::min(LongestWord, LeastText);
	Widths.Given = Widths.Natural;
	return Widths;
}

/** Sum of the widths of columns that stand side by side, with the gaps. */
size_t Sum(const std::vector<FWidths>& Widths, size_t FWidths::*Which)
{
	size_t Total = Widths.empty() ? 0 : (Widths.size() - 1) * Gap;
	for (const FWidths& Column : Widths)
	{
		Total += Column.*Which;
	}
	return Total;
}

/** Columns of one kind give way, each by its part of what it can give, until the table is Available wide or they are as
 * narrow as they may be. */
void Narrow(const FTextTable& Table, ETextColumn Kind, size_t Available, std::vector<FWidths>& Widths)
{
	size_t TooMany = Sum(Widths, &FWidths::Given);
	TooMany -= std::min(TooMany, Available);
	size_t CanGive = 0;
	for (size_t Column = 0; Column < Widths.size(); ++Column)
	{
		CanGive += Table.Columns[Column].Kind == Kind ? Widths[Column].Given - Widths[Column].Least : 0;
	}
	TooMany = std::min(TooMany, CanGive);
	for (size_t Column = 0; Column < Widths.size() && CanGive > 0; ++Column)
	{
		if (Table.Columns[Column].Kind != Kind)
		{
			continue;
		}
		const size_t Own = Widths[Column].Given - Widths[Column].Least;
		const size_t Given = (TooMany * Own + CanGive - 1) / CanGive; // the last one takes what rounding left
		Widths[Column].Given -= std::min(Given, Own);
		TooMany -= std::min(Given, Own);
		CanGive -= Own;
	}
}

/** Breaks a cell at blanks, a longer word behind the last sign in it that fits. */
std::vector<std::string> Wrap(const std::string& Cell, size_t Columns)
{
	std::vector<std::string> Lines;
	std::string Rest = Cell;
	while (CountColumns(Rest) > Columns)
	{
		size_t End = 0; // bytes that fit
		for (size_t Next = 1; CountColumns(Rest.substr(0, Next)) <= Columns; ++Next)
		{
			End = Next;
		}
		const size_t Blank = Rest.rfind(' ', End);
		if (Blank != std::string::npos && Blank > 0)
		{
			End = Blank;
		}
		else if (const size_t Sign = Rest.find_last_of("(,/_:|", End - 1); Sign != std::string::npos && Sign > 0)
		{
			End = Sign + 1;
		}
		Lines.push_back(Rest.substr(0, End));
		Rest.erase(0, std::min(Rest.find_first_not_of(' ', End), Rest.size()));
	}
	Lines.push_back(Rest);
	return Lines;
}

std::string FormatRow(
	const FTextTable& Table, size_t Row, const std::vector<FWidths>& Widths, const std::string& Indent)
{
	std::vector<std::vector<std::string>> Cells;
	size_t NumLines = 1;
	for (size_t Column = 0; Column < Widths.size(); ++Column)
	{
		const std::string& Cell = Table.Rows[Row][Column];
		Cells.push_back(Table.Columns[Column].Kind == ETextColumn::Text
							? Wrap(Cell, std::max(Widths[Column].Given, size_t(1)))
							: std::vector{ShortenMiddle(Cell, Widths[Column].Given)});
		NumLines = std::max(NumLines, Cells.back().size());
	}
	const std::string Color = Row < Table.Colors.size() ? Table.Colors[Row] : "";
	std::string Text;
	for (size_t Index = 0; Index < NumLines; ++Index)
	{
		std::string Line;
		for (size_t Column = 0; Column < Widths.size(); ++Column)
		{
			const std::string Cell = Index < Cells[Column].size() ? Cells[Column][Index] : "";
			const size_t Width = Widths[Column].Given;
			const std::string Padding(Width - std::min(Width, CountColumns(Cell)), ' ');
			const bool bRight = Table.Columns[Column].Kind == ETextColumn::Number;
			Line += (Column > 0 ? std::string(Gap, ' ') : "") + (bRight ? Padding + Cell : Cell + Padding);
		}
		Line = Indent + Line.substr(0, Line.find_last_not_of(' ') + 1);
		Text += Color + Line + (Color.empty() ? "" : "\x1b[0m") + "\n";
	}
	return Text;
}

/** Allows narrower columns, once no more columns may be left out. */
void Tighten(const FTextTable& Table, std::vector<FWidths>& Widths)
{
	for (size_t Column = 0; Column < Widths.size(); ++Column)
	{
		const bool bNumber = Table.Columns[Column].Kind == ETextColumn::Number;
		Widths[Column].Least = bNumber ? Widths[Column].Least : std::min(Widths[Column].Least, LeastOfAll);
	}
}

/** Takes out the column that goes first; its name. Empty where all stay. */
std::string LeaveOneOut(FTextTable& Table, std::vector<FWidths>& Widths)
{
	const auto First = std::ranges::max_element(Table.Columns, {}, &FTextColumn::LeaveOut);
	if (First == Table.Columns.end() || First->LeaveOut == 0)
	{
		return "";
	}
	const std::ptrdiff_t At = First - Table.Columns.begin();
	const std::string Name = Table.Rows[0][static_cast<size_t>(At)];
	for (std::vector<std::string>& Row : Table.Rows)
	{
		Row.erase(Row.begin() + At);
	}
	Table.Columns.erase(First);
	Widths.erase(Widths.begin() + At);
	return Name;
}

} // namespace

std::string FTextTable::Format(int Width, const std::string& Indent) const
{
	if (Rows.empty())
	{
		return "";
	}
	FTextTable Table = *this;
	for (std::vector<std::string>& Row : Table.Rows)
	{
		std::ranges::transform(Row, Row.begin(), [](const std::string& Cell) { return MakePrintable(Cell, false); });
	}
	std::vector<FWidths> Widths;
	for (size_t Column = 0; Column < Columns.size(); ++Column)
	{
		Widths.push_back(Measure(Table, Column));
	}
	std::string LeftOut;
	if (Width > 0)
	{
		const size_t Available = static_cast<size_t>(Width) - std::min(static_cast<size_t>(Width), Indent.size());
		while (Sum(Widths, &FWidths::Least) > Available)
		{
			const std::string Name = LeaveOneOut(Table, Widths);
			if (Name.empty())
			{
				break;
			}
			LeftOut += (LeftOut.empty() ? "" : ", ") + Name;
		}
		if (Sum(Widths, &FWidths::Least) > Available)
		{
			Tighten(Table, Widths);
		}
		Narrow(Table, ETextColumn::Text, Available, Widths);
		Narrow(Table, ETextColumn::Name, Available, Widths);
	}
	std::string Text;
	for (size_t Row = 0; Row < Table.Rows.size(); ++Row)
	{
		Text += FormatRow(Table, Row, Widths, Indent);
	}
	return Text + (LeftOut.empty() ? "" : Indent + "(no room at this width: " + LeftOut + ")\n");
}

std::string ShortenMiddle(const std::string& Text, size_t Columns)
{
	const std::string Ellipsis = "...";
	const size_t Whole = CountColumns(Text);
	if (Whole <= Columns)
	{
		return Text;
	}
	const size_t Kept = Columns - std::min(Columns, Ellipsis.size());
	const auto BytesOf = [&Text](size_t Count)
	{
		size_t Bytes = 0;
		while (Bytes < Text.size() && CountColumns(Text.substr(0, Bytes + 1)) <= Count)
		{
			++Bytes;
		}
		return Bytes;
	};
	const size_t NumBehind = Kept / 2;
	return Text.substr(0, BytesOf(Kept - NumBehind)) + Ellipsis + Text.substr(BytesOf(Whole - NumBehind));
}

} // namespace Drydock
