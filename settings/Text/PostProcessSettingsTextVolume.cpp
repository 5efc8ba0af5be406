// Finds volumes in the text of copied actors: their settings, their place and the shape of their brush.
#include "PostProcessSettingsTextVolume.h"

#include "DiagnosticList.h"
#include "PostProcessSettingsTextBlocks.h"
#include "PostProcessSettingsTextScan.h"
#include "PostProcessSettingsTextValue.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Half the side of the engine's default brush, cm. */
constexpr double DefaultExtent = 100.0;

bool Contains(const std::string& Text, const char* Part)
{
	return Text.find(Part) != std::string::npos;
}

/** Whether a block's Settings=(..) are a volume's: other classes have members of that name. */
bool HasVolumeSettings(const FEngineTextBlock& Block)
{
	const FEngineTextItem* Settings = Block.Find("Settings");
	if (Settings == nullptr || Settings->Value.Kind != EEngineTextKind::Struct)
	{
		return false;
	}
	const std::vector<FEngineTextItem>& Items = Settings->Value.Items;
	return Block.Class.empty() || Contains(Block.Class, "PostProcess") ||
		   std::ranges::any_of(Items, [](const FEngineTextItem& Item) { return Item.Name.starts_with("bOverride_"); });
}

/** Reads plain properties of a block; a wrong one is reported and keeps its default. */
class FPropertyReader
{
public:
	FPropertyReader(const FEngineTextBlock& InBlock, const std::string& InWhere, FSettingsTextMessages& InMessages)
		: Block(InBlock)
		, Where(InWhere)
		, Messages(InMessages)
	{
	}

	void Read(const char* Name, bool& bOutValue)
	{
		if (const FEngineTextItem* Item = Block.Find(Name))
		{
			const bool bDigit =
				Item->Value.Kind == EEngineTextKind::Number && (Item->Value.Number == 0.0 || Item->Value.Number == 1.0);
			if (Item->Value.Kind == EEngineTextKind::Bool || bDigit)
			{
				bOutValue = bDigit ? Item->Value.Number == 1.0 : Item->Value.Bool;
				return;
			}
			Refuse(*Item, Item->Value, "True or False");
		}
	}

	void Read(const char* Name, double& OutNumber)
	{
		if (const FEngineTextItem* Item = Block.Find(Name))
		{
			ReadNumber(*Item, Item->Value, OutNumber);
		}
	}

	/** (X=..,Y=..,Z=..), any of them. */
	void Read(const char* Name, const char* const (&Parts)[3], double (&OutVector)[3])
	{
		const FEngineTextItem* Item = Block.Find(Name);
		if (Item == nullptr)
		{
			return;
		}
		const std::string Example = std::string("(") + Parts[0] + "=..," + Parts[1] + "=..," + Parts[2] + "=..)";
		if (Item->Value.Kind != EEngineTextKind::Struct)
		{
			Refuse(*Item, Item->Value, Example);
			return;
		}
		for (const FEngineTextItem& Member : Item->Value.Items)
		{
			const auto Part = std::ranges::find_if(
				Parts, [&](const char* Each) { return ToLowerCase(Each) == ToLowerCase(Member.Name); });
			if (Part == std::end(Parts))
			{
				Messages.Error(ErrorTextUnknownName, Member.Offset, Where + Name,
					"expected " + Example + ", found " +
						(Member.Name.empty() ? Member.Value.Describe() : Member.GetKey()));
				return;
			}
			ReadNumber(*Item, Member.Value, OutVector[Part - std::begin(Parts)]);
		}
	}

private:
	void ReadNumber(const FEngineTextItem& Item, const FEngineTextValue& Value, double& OutNumber)
	{
		if (Value.Kind != EEngineTextKind::Number)
		{
			Refuse(Item, Value, "a number");
		}
		else if (!std::isfinite(Value.Number))
		{
			Messages.Error(ErrorTextNotFinite, Value.Offset, Where + Item.Name,
				"expected a finite number, found " + Value.Describe());
		}
		else
		{
			OutNumber = Value.Number;
		}
	}

	void Refuse(const FEngineTextItem& Item, const FEngineTextValue& Value, const std::string& Expected)
	{
		Messages.Error(ErrorTextWrongType, Value.Offset, Where + Item.Name,
			"expected " + Expected + ", found " + Value.Describe());
	}

	const FEngineTextBlock& Block;
	const std::string& Where;
	FSettingsTextMessages& Messages;
};

/** The brush of an actor, before its transform. */
struct FBrush
{
	bool bGiven = false; // the text says anything of it
	bool bBox = true;
	double Min[3] = {-DefaultExtent, -DefaultExtent, -DefaultExtent};
	double Max[3] = {DefaultExtent, DefaultExtent, DefaultExtent};
};

/** A box has all corners of its polygons on its bounds. */
void ReadVertices(const std::vector<double>& Vertices, FBrush& Brush)
{
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		Brush.Min[Axis] = Brush.Max[Axis] = Vertices[Axis];
		for (size_t Index = Axis; Index < Vertices.size(); Index += 3)
		{
			Brush.Min[Axis] = std::min(Brush.Min[Axis], Vertices[Index]);
			Brush.Max[Axis] = std::max(Brush.Max[Axis], Vertices[Index]);
		}
		for (size_t Index = Axis; Index < Vertices.size(); Index += 3)
		{
			Brush.bBox &= Vertices[Index] == Brush.Min[Axis] || Vertices[Index] == Brush.Max[Axis];
		}
	}
	Brush.bGiven = true;
}

void ReadBuilder(
	const FEngineTextBlock& Builder, const std::string& Where, FBrush& Brush, FSettingsTextMessages& Messages)
{
	Brush.bGiven = true;
	Brush.bBox &= Contains(Builder.Class, "CubeBuilder") || Builder.Name.starts_with("CubeBuilder");
	constexpr const char* Names[] = {"X", "Y", "Z"};
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		double Size = 2.0 * Brush.Max[Axis];
		FPropertyReader(Builder, Where, Messages).Read(Names[Axis], Size);
		Brush.Max[Axis] = std::fabs(Size) / 2.0;
		Brush.Min[Axis] = -Brush.Max[Axis];
	}
}

/** The box of an actor's brush; empty with a warning if it is not a box, without a warning if the text has no brush. */
std::optional<FVolumeTextBox> ReadBox(
	const FEngineTextBlock& Actor, const std::string& Where, FSettingsTextMessages& Messages)
{
	constexpr const char* Axes[] = {"X", "Y", "Z"};
	constexpr const char* Angles[] = {"Pitch", "Yaw", "Roll"};
	FBrush Brush;
	FVolumeTextBox Box;
	double Scale[3] = {1.0, 1.0, 1.0};
	for (const FEngineTextBlock& Object : Actor.Blocks)
	{
		if (Contains(Object.Class, "BrushComponent") || Object.Name.starts_with("BrushComponent"))
		{
			Brush.bGiven = true;
			FPropertyReader Reader(Object, Where, Messages);
			Reader.Read("RelativeLocation", Axes, Box.Center);
			Reader.Read("RelativeRotation", Angles, Box.Rotation);
			Reader.Read("RelativeScale3D", Axes, Scale);
		}
		else if (Actor.Vertices.empty() && (Contains(Object.Class, "Builder") || Contains(Object.Name, "Builder")))
		{
			ReadBuilder(Object, Where, Brush, Messages);
		}
	}
	if (!Actor.Vertices.empty())
	{
		ReadVertices(Actor.Vertices, Brush);
	}
	const bool bRotated = std::ranges::any_of(Box.Rotation, [](double A) { return A != 0.0; });
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		const double Middle = (Brush.Min[Axis] + Brush.Max[Axis]) / 2.0;
		Brush.bBox &= Middle == 0.0 || !bRotated;
		Box.Center[Axis] += Middle * Scale[Axis];
		Box.Extent[Axis] = (Brush.Max[Axis] - Brush.Min[Axis]) / 2.0 * std::fabs(Scale[Axis]);
		Brush.bBox &= std::isfinite(Box.Center[Axis]) && std::isfinite(Box.Extent[Axis]);
	}
	if (!Brush.bBox)
	{
		Messages.Warn(WarnTextShape, Actor.Offset, Where + "Brush",
			"the volume's brush is not a box around its pivot; it is left out");
	}
	return Brush.bGiven && Brush.bBox ? std::optional(Box) : std::nullopt;
}

FVolumeText ReadVolume(const FEngineTextBlock& Block, FSettingsTextMessages& Messages)
{
	FVolumeText Volume;
	const FEngineTextItem* Label = Block.Find("ActorLabel");
	Volume.Name = Label != nullptr && !Label->Value.String.empty() ? Label->Value.String : Block.Name;
	const std::string Where = Block.Name.empty() ? "" : Block.Name + ".";
	FPropertyReader Reader(Block, Where, Messages);
	Reader.Read("bEnabled", Volume.bEnabled);
	Volume.bUnbound = Block.Kind.empty();
	Reader.Read("bUnbound", Volume.bUnbound);
	Reader.Read("Priority", Volume.Priority);
	Reader.Read("BlendRadius", Volume.BlendRadius);
	Reader.Read("BlendWeight", Volume.BlendWeight);
	if (Volume.BlendWeight != std::clamp(Volume.BlendWeight, 0.0, 1.0))
	{
		Messages.Warn(WarnTextWeightClamped, Block.Find("BlendWeight")->Value.Offset, Where + "BlendWeight",
			"BlendWeight is clamped to 0..1");
		Volume.BlendWeight = std::clamp(Volume.BlendWeight, 0.0, 1.0);
	}
	Volume.Box = ReadBox(Block, Where, Messages);
	if (!Volume.Box && !Volume.bUnbound)
	{
		Messages.Warn(WarnTextShape, Block.Offset, Where + "Brush",
			"the volume is bounded and the text has no box for it: give it \"bounds\" or make it bUnbound");
	}
	Volume.Settings = ReadSettingsStruct(Block.Find("Settings")->Value, Where, Messages);
	return Volume;
}

void CollectVolumes(const FEngineTextBlock& Block, std::vector<FVolumeText>& Volumes, FSettingsTextMessages& Messages)
{
	if (HasVolumeSettings(Block))
	{
		Volumes.push_back(ReadVolume(Block, Messages));
	}
	for (const FEngineTextBlock& Inner : Block.Blocks)
	{
		CollectVolumes(Inner, Volumes, Messages);
	}
}

std::string WriteVector(const char* const (&Parts)[3], const double (&Vector)[3])
{
	std::string Text = "(";
	for (int Index = 0; Index < 3; ++Index)
	{
		Text += std::string(Index == 0 ? "" : ",") + Parts[Index] + "=" + WriteNumberText(Vector[Index]);
	}
	return Text + ")";
}

void WriteBox(const FVolumeTextBox& Box, const std::string& Indent, std::string& Text)
{
	constexpr const char* Axes[] = {"X", "Y", "Z"};
	constexpr const char* Angles[] = {"Pitch", "Yaw", "Roll"};
	const double Scale[] = {
		Box.Extent[0] / DefaultExtent, Box.Extent[1] / DefaultExtent, Box.Extent[2] / DefaultExtent};
	Text += Indent + "Begin Object Name=\"BrushComponent0\"\n";
	Text += Indent + "   RelativeLocation=" + WriteVector(Axes, Box.Center) + "\n";
	Text += Indent + "   RelativeRotation=" + WriteVector(Angles, Box.Rotation) + "\n";
	Text += Indent + "   RelativeScale3D=" + WriteVector(Axes, Scale) + "\n";
	Text += Indent + "End Object\n";
}

/** Without what would end the string or the line. */
std::string CleanLabel(std::string Label)
{
	std::replace_if(
		Label.begin(), Label.end(),
		[](char Character)
		{ return static_cast<unsigned char>(Character) < 0x20 || Character == '"' || Character == '\\'; },
		'_');
	return Label;
}

} // namespace

std::vector<FVolumeText> ReadVolumesText(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	FSettingsTextMessages Messages(Text, File, Diagnostics);
	std::vector<FVolumeText> Volumes;
	if (!CheckEngineTextEncoding(Text, Messages))
	{
		return Volumes;
	}
	size_t Begin = Text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
	SkipEngineTextSpace(Text, Begin);
	if (Begin < Text.size() && Text[Begin] == '(')
	{
		FVolumeText Volume;
		Volume.bUnbound = true;
		Volume.Settings = ReadSettingsText(Text, File, Diagnostics);
		Volumes.push_back(std::move(Volume));
		return Volumes;
	}
	const size_t NumBefore = Diagnostics.size();
	CollectVolumes(ParseEngineTextBlocks(Text, Messages), Volumes, Messages);
	if (Volumes.empty() && Diagnostics.size() == NumBefore)
	{
		Messages.Error(ErrorTextNoSettings, Begin, "",
			"there are no post-process settings in this text: expected (NAME=VALUE,..) or an actor with Settings=(..)");
	}
	Diagnostics = LimitDiagnostics(Diagnostics);
	return Volumes;
}

std::string WriteVolumesText(
	const std::vector<FVolumeText>& Volumes, ESettingsTextForm Form, std::vector<FDiagnostic>& Diagnostics)
{
	const bool bFull = Form == ESettingsTextForm::Full;
	const std::string Indent = "         ";
	std::string Text = "Begin Map\n   Begin Level\n";
	for (size_t Index = 0; Index < Volumes.size(); ++Index)
	{
		const FVolumeText& Volume = Volumes[Index];
		const auto Add = [&](const char* Name, const std::string& Value, bool bWritten)
		{
			Text += bFull || bWritten ? Indent + Name + "=" + Value + "\n" : "";
		};
		const size_t NumBefore = Diagnostics.size();
		Text += "      Begin Actor Class=/Script/Engine.PostProcessVolume Name=PostProcessVolume_" +
				std::to_string(Index) + "\n";
		if (Volume.Box)
		{
			WriteBox(*Volume.Box, Indent, Text);
		}
		Text += Indent + "Settings=" + WriteSettingsText(Volume.Settings, Form, Diagnostics) + "\n";
		Add("Priority", WriteNumberText(Volume.Priority), Volume.Priority != 0.0);
		Add("BlendRadius", WriteNumberText(Volume.BlendRadius), Volume.BlendRadius != 100.0);
		Add("BlendWeight", WriteNumberText(Volume.BlendWeight), Volume.BlendWeight != 1.0);
		Add("bEnabled", Volume.bEnabled ? "True" : "False", !Volume.bEnabled);
		Add("bUnbound", Volume.bUnbound ? "True" : "False", Volume.bUnbound);
		Text += Volume.Name.empty() ? "" : Indent + "ActorLabel=\"" + CleanLabel(Volume.Name) + "\"\n";
		Text += "      End Actor\n";
		std::for_each(Diagnostics.begin() + static_cast<std::ptrdiff_t>(NumBefore), Diagnostics.end(),
			[&](FDiagnostic& Diagnostic) { Diagnostic.Where = Volume.Name; });
	}
	return Text + "   End Level\nEnd Map\n";
}

} // namespace Drydock
