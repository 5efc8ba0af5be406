// Prints what an import understood.
#include "Import/ImportReport.h"

#include "Import/ImportFigures.h"
#include "Import/ImportWrite.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"

#include <algorithm>

namespace Drydock
{

namespace
{

std::string JoinChannels(const FImportTarget& Target)
{
	std::string Text = Target.Channels[0];
	for (size_t Index = 1; Index < Target.Channels.size(); ++Index)
	{
		const std::string& Name = Target.Channels[Index];
		Text += " " + Name.substr(Name.find('.') + 1);
	}
	return Text;
}

/** The objects that --toon and --stencil chose. */
std::string DescribeChoices(const std::vector<FImportChoice>& Choices)
{
	std::string Text;
	for (const FImportChoice& Choice : Choices)
	{
		Text += (Text.empty() ? "" : ", ") + Choice.Text;
		if (Choice.NumObjects > 0)
		{
			Text += fmt::format(" ({} {})", Choice.NumObjects, Choice.NumObjects == 1 ? "object" : "objects");
		}
	}
	return Text;
}

struct FTableRow
{
	std::string Channels;
	std::string From;
	std::string As;
	std::string Figures;
	std::string Remark;
};

std::vector<FTableRow> MakeRows(const FImportStory& Story)
{
	std::vector<FTableRow> Rows;
	for (const FImportRow& Row : Story.Plan.Rows)
	{
		Rows.push_back({JoinChannels(*Row.Target), DescribeSource(Story.Layers, Row), DescribeEncoding(Row),
			DescribeFigures(Story.Scene, *Row.Target), Row.Remark});
	}
	const auto AddChosen = [&](const char* Group, const std::vector<FImportChoice>& Choices, const char* Option)
	{
		if (Choices.empty())
		{
			return;
		}
		const FImportTarget& Target = *FindImportTarget(Group);
		if (Story.Scene.Find(Target.Channels[0]) == nullptr)
		{
			return;
		}
		const auto Known = std::ranges::find(Rows, Target.Channels[0], &FTableRow::Channels);
		const std::string From = std::string(Option) + " " + DescribeChoices(Choices);
		if (Known != Rows.end())
		{
			Known->From += ", " + From;
			return;
		}
		Rows.push_back({Target.Channels[0], From, "", DescribeFigures(Story.Scene, Target), ""});
	};
	AddChosen("customstencil", Story.Choices.Stencil, "--stencil");
	AddChosen("customdepth", Story.Choices.Stencil, "--stencil");
	AddChosen("shadingmodel", Story.Choices.Toon, "--toon");
	AddChosen("custommask", Story.Choices.Toon, "--toon");
	return Rows;
}

std::string FormatObjects(const std::vector<FImportMatte>& Mattes)
{
	constexpr size_t MaxListed = 20;
	std::string Text;
	for (const FImportMatte& Matte : Mattes)
	{
		std::string Names;
		size_t NumListed = 0;
		for (const auto& [Name, Id] : Matte.Objects)
		{
			if (NumListed++ == MaxListed)
			{
				Names += fmt::format(", ... ({} in all)", Matte.Objects.size());
				break;
			}
			Names += (Names.empty() ? "" : ", ") + Name;
		}
		Text += "objects of " + Matte.Name + ": " + Names + "\n";
	}
	return Text;
}

} // namespace

std::string DescribeSource(const FImportLayers& Layers, const FImportRow& Row)
{
	std::vector<std::string> Names; // of layers, in the order in which they come
	std::vector<std::string> Components;
	for (const std::optional<FImportSource>& Source : Row.Sources)
	{
		if (!Source)
		{
			continue;
		}
		const FImportLayer& Layer = Layers.Layers[Source->Layer];
		const std::string& Channel = Layer.Find(Source->Slot)->Name;
		const size_t Dot = Channel.rfind('.');
		const std::string Component = Dot == std::string::npos ? Channel : Channel.substr(Dot + 1);
		if (Names.empty() || Names.back() != Layer.Label)
		{
			Names.push_back(Layer.Label);
			Components.emplace_back();
		}
		Components.back() += Component.size() == 1 ? Component : (Components.back().empty() ? "" : " ") + Component;
	}
	std::string Text;
	for (size_t Index = 0; Index < Names.size(); ++Index)
	{
		const bool bSame = Names[Index] == Components[Index];
		Text += (Index == 0 ? "" : ", ") + Names[Index] + (bSame ? "" : " " + Components[Index]);
	}
	return Text;
}

std::string DescribeEncoding(const FImportRow& Row)
{
	const FImportEncoding& Encoding = Row.Encoding;
	switch (Row.Target->Kind)
	{
	case EImportKind::Depth:
		return Encoding.Depth == EImportDepth::Device ? "reversed device depth, near plane 10 cm"
			   : Encoding.Depth == EImportDepth::Mist
				   ? fmt::format("mist from {:g} m over {:g} m", Encoding.Mist.Start, Encoding.Mist.Depth)
			   : Encoding.Depth == EImportDepth::Inverse ? "1 / " + Encoding.Unit
			   : Encoding.Depth == EImportDepth::Ray     ? Encoding.Unit + " from the camera's place"
														 : Encoding.Unit;
	case EImportKind::Normal:
	{
		static const std::array<const char*, 4> Spaces = {
			"Unreal's world", "world, Z up", "world, Y up", "the camera's space"};
		return std::string(Encoding.bHalved ? "0..1" : "-1..1") + ", " +
			   Spaces[static_cast<size_t>(Encoding.NormalSpace)];
	}
	case EImportKind::Velocity:
	{
		static const std::array<const char*, 5> Ways = {"pixels, y down", "pixels, y up", "screen position -2..2, y up",
			"around 0.5, of the screen", "pixels to where it was, y up"};
		return std::string(Ways[static_cast<size_t>(Encoding.Velocity)]) + (Encoding.bFlipVelocity ? ", flipped" : "");
	}
	case EImportKind::Color:
		return "linear" + std::string(Encoding.Alpha == EImportAlpha::Straight ? ", times alpha"
									  : Encoding.Alpha == EImportAlpha::Opaque ? ", opaque"
																			   : "");
	case EImportKind::Number:
		return "whole numbers";
	default:
		return "as it is";
	}
}

std::string FormatImportTable(const FImportStory& Story, int Width)
{
	std::vector<std::vector<std::string>> Cells = {{"channel", "from", "as", "holds"}};
	for (const FTableRow& Row : MakeRows(Story))
	{
		Cells.push_back(
			{Row.Channels, Row.From, Row.As, Row.Figures + (Row.Remark.empty() ? "" : " (" + Row.Remark + ")")});
	}
	std::string Text = fmt::format("{} x {} pixels\n", Story.Scene.Width, Story.Scene.Height);
	Text += FTextTable{std::vector<FTextColumn>(4), Cells}.Format(Width);
	if (!Story.Plan.LeftOut.empty())
	{
		Cells = {{"left out", "why"}};
		for (const FImportLeftOut& LeftOut : Story.Plan.LeftOut)
		{
			Cells.push_back({Story.Layers.Layers[LeftOut.Layer].Label, LeftOut.Why});
		}
		Text += "\n" + FTextTable{{{ETextColumn::Name}, {ETextColumn::Text}}, Cells}.Format(Width);
	}
	const std::string Objects = FormatObjects(Story.Mattes);
	return Text + (Objects.empty() ? "" : "\n" + Objects);
}

std::string FormatImportJson(const FImportStory& Story)
{
	FJsonWriter Writer('{');
	Writer.Members({{"width", Story.Scene.Width}, {"height", Story.Scene.Height}});
	Writer.Array("channels", MakeRows(Story),
		[&](const FTableRow& Row)
		{
			Writer.BeginObject();
			Writer.Members({{"channels", Row.Channels}, {"from", Row.From}, {"as", Row.As}, {"holds", Row.Figures}});
			Writer.EndObject();
		});
	Writer.Array("leftOut", Story.Plan.LeftOut,
		[&](const FImportLeftOut& LeftOut) {
			Writer.Object({{"layer", Story.Layers.Layers[LeftOut.Layer].Label}, {"why", LeftOut.Why}});
		});
	Writer.Member("missing", FindMissingChannels(Story.Scene));
	Writer.Array("objects", Story.Mattes,
		[&](const FImportMatte& Matte)
		{
			for (const auto& [Name, Id] : Matte.Objects)
			{
				Writer.Value(Name);
			}
		});
	return Writer.GetText();
}

} // namespace Drydock
