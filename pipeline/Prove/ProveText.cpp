// Writes what `drydock prove` found, for a person and for programs.
#include "Prove/Prove.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

std::string FormatValues(const std::vector<double>& Values)
{
	std::string Text = JoinText(Values, ", ", [&](const double Value) { return NumberText(Value); });
	return Values.size() > 1 ? "(" + Text + ")" : Text;
}

std::string FormatPixel(const FPixelDifference& Pixel)
{
	return fmt::format("pixel ({}, {}) is {}, and {}{}", Pixel.X, Pixel.Y, FormatValues(Pixel.Base),
		FormatValues(Pixel.Other),
		Pixel.NumPixels > 1 ? fmt::format("; first of {} pixels", Pixel.NumPixels) : std::string());
}

std::string FormatFirstPass(const FFirstDifference& Pass)
{
	std::string Text = fmt::format("      first in pass {}{}{}: {}{} ", Pass.Pass,
		Pass.Shader.empty() ? "" : ", " + Pass.Shader, Pass.Owner.empty() ? "" : ", of " + Pass.Owner, Pass.Resource,
		Pass.Mip > 0 ? fmt::format(" mip {}", Pass.Mip) : std::string());
	Text += (Pass.Pixel ? FormatPixel(*Pass.Pixel) : "is drawn " + Pass.Sizes) + "\n";
	for (const std::string& Input : Pass.PartlyDrawn)
	{
		Text += "      it reads " + Input + " was written before\n";
	}
	return Text;
}

std::string FormatVerdict(const FProven& Proven)
{
	if (!Proven.NotRun.empty())
	{
		return "not asked: " + Proven.NotRun;
	}
	if (!Proven.Holds())
	{
		return !Proven.Unwritten.empty() ? "NOT REPEATABLE" : Proven.Error.empty() ? "DIFFERS" : "DOES NOT RUN";
	}
	if (Proven.MayBeMeant())
	{
		return "DIFFERS in one pass, which may be meant";
	}
	return Proven.NumRounded == 0
			   ? "the same bits"
			   : fmt::format("the same but for rounding: {} values by a step of 8 bits at most", Proven.NumRounded);
}

void WritePixel(FJsonWriter& Writer, const char* Name, const FPixelDifference& Pixel)
{
	Writer.Key(Name).BeginObject();
	Writer.Members({{"x", Pixel.X}, {"y", Pixel.Y}, {"pixels", Pixel.NumPixels}});
	for (const auto& [Key, Values] : {std::pair("base", &Pixel.Base), std::pair("other", &Pixel.Other)})
	{
		// As text, for it may be no number.
		Writer.Member(Key, *Values | std::views::transform([](double Value) { return NumberText(Value); }));
	}
	Writer.EndObject();
}

} // namespace

std::string DescribeDifference(const FProven& Proven)
{
	std::string Text;
	if (!Proven.Error.empty())
	{
		return "      " + Proven.Error + "\n";
	}
	if (!Proven.Unwritten.empty())
	{
		return "      " + Proven.Unwritten +
			   "\n      the frame is not repeatable on a GPU, and nothing else is judged\n";
	}
	if (Proven.FirstPass)
	{
		Text += FormatFirstPass(*Proven.FirstPass);
	}
	Text += Proven.MayBeMeant() ? ""
			: Proven.Final      ? "      the final picture: " + FormatPixel(*Proven.Final) + "\n"
								: "      the final picture is " + Proven.OtherSize + "\n";
	return Text + "      likely: " + Proven.Equivalence->Likely + "\n";
}

std::string MakeProveText(const std::string& Config, const std::vector<FProven>& Proven, int Width)
{
	std::string Text = Config + " gives the same picture:\n";
	FTextTable Table{{{ETextColumn::Name}, {ETextColumn::Text}, {ETextColumn::Text}}, {}};
	std::string Differences;
	size_t NumBroken = 0;
	for (const FProven& One : Proven)
	{
		Table.Rows.push_back({One.Equivalence->Name, One.Equivalence->What, FormatVerdict(One)});
		Differences +=
			One.Holds() && !One.MayBeMeant() ? "" : "  " + One.Equivalence->Name + ":\n" + DescribeDifference(One);
		NumBroken += One.Holds() ? 0 : 1;
	}
	return Text + Table.Format(Width, "  ") + Differences +
		   (NumBroken == 0 ? fmt::format("{} equivalences, all of which hold\n", Proven.size())
						   : fmt::format("{} equivalences, {} broken\n", Proven.size(), NumBroken));
}

std::string MakeProveJson(const std::string& Config, const std::vector<FProven>& Proven)
{
	FJsonWriter Writer('{');
	Writer.Members({{"config", Config},
		{"holds", std::all_of(Proven.begin(), Proven.end(), [](const FProven& One) { return One.Holds(); })}});
	Writer.Array("equivalences", Proven,
		[&](const FProven& One)
		{
			Writer.BeginObject();
			Writer.Members({{"name", One.Equivalence->Name}, {"what", One.Equivalence->What}, {"holds", One.Holds()},
				{"notAsked", One.NotRun}, {"error", One.Error}, {"unwritten", One.Unwritten},
				{"otherSize", One.OtherSize}, {"roundedValues", One.NumRounded},
				{"likely", One.Holds() && !One.MayBeMeant() ? "" : One.Equivalence->Likely}});
			if (One.FirstPass)
			{
				Writer.Key("firstPass").BeginObject();
				Writer.Members({{"pass", One.FirstPass->Pass}, {"shader", One.FirstPass->Shader},
					{"plugin", One.FirstPass->Owner}, {"resource", One.FirstPass->Resource},
					{"mip", One.FirstPass->Mip}, {"sizes", One.FirstPass->Sizes}});
				if (One.FirstPass->Pixel)
				{
					WritePixel(Writer, "pixel", *One.FirstPass->Pixel);
				}
				Writer.Array(
					"partlyDrawn", One.FirstPass->PartlyDrawn, [&](const std::string& Input) { Writer.Value(Input); });
				Writer.EndObject();
			}
			if (One.Final)
			{
				WritePixel(Writer, "final", *One.Final);
			}
			Writer.EndObject();
		});
	return Writer.GetText();
}

} // namespace Drydock
