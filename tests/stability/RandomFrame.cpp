// Makes random frames, and the file that a frame's scene is read from.
#include "RandomFrame.h"

#include "PassFactory.h"
#include "PostProcessSettingsReflection.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace Drydock;
using FJson = nlohmann::ordered_json;

namespace Stability
{

namespace
{

/** SplitMix64: the same numbers everywhere. */
class FChance
{
public:
	/** Seeds beside each other have nothing in common: the step of the sequence is another one than theirs. */
	explicit FChance(uint64_t Seed)
		: State(Seed * 0xD1B54A32D192ED03u)
	{
		State = Next();
	}

	double Unit() { return static_cast<double>(Next() >> 11) * 0x1p-53; } // 0 to 1, without 1
	bool Is(double Probability) { return Unit() < Probability; }
	double Between(double Min, double Max) { return Min + (Max - Min) * Unit(); }
	double Scale(double Min, double Max) { return Min * std::pow(Max / Min, Unit()); } // even in the logarithm
	int Whole(int Min, int Max) { return Min + static_cast<int>(Next() % static_cast<uint64_t>(Max - Min + 1)); }

	template<typename T>
	const T& Of(const std::vector<T>& List)
	{
		return List[static_cast<size_t>(Whole(0, static_cast<int>(List.size()) - 1))];
	}

private:
	uint64_t Next()
	{
		uint64_t Mixed = State += 0x9E3779B97F4A7C15u;
		Mixed = (Mixed ^ (Mixed >> 30)) * 0xBF58476D1CE4E5B9u;
		Mixed = (Mixed ^ (Mixed >> 27)) * 0x94D049BB133111EBu;
		return Mixed ^ (Mixed >> 31);
	}

	uint64_t State;
};

const std::vector<std::string> AllChannels = {"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z",
	"velocity.X", "velocity.Y", "basecolor.R", "basecolor.G", "basecolor.B", "shadingmodel.ID", "custommask.B",
	"shadow.R", "shadow.G", "translucency.R", "translucency.G", "translucency.B", "translucency.A"};

constexpr int NumChannels = 21;
constexpr int NumWithoutTranslucency = NumChannels - 4;

enum EChannel
{
	Red,
	Green,
	Blue,
	Depth = 4,
	VelocityX = 8,
	VelocityY,
	ShadingModel = 13,
	Mask,
};

constexpr double Toon = 8.0;
constexpr double Lit = 1.0;

/** A grey, still, lit wall without a light, with the first of all channels. */
FImage MakeWall(int Width, int Height, double Grey, int NumChannels)
{
	const std::vector<double> Texel = {Grey, Grey, Grey, 1, 5, 0, -1, 0, 0, 0, 0.5, 0.5, 0.5, Lit, 0, 1, 1, 0, 0, 0, 1};
	FImage Picture{Width, Height, NumChannels, {}};
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		Picture.Values.insert(Picture.Values.end(), Texel.begin(), Texel.begin() + NumChannels);
	}
	return Picture;
}

double& At(FImage& Picture, int X, int Y, int Channel)
{
	return Picture.Values[static_cast<size_t>((Y * Picture.Width + X) * Picture.NumChannels + Channel)];
}

/** A value of light that is hard for some pass. */
double MakeHardLight(FChance& Chance)
{
	return Chance.Of(std::vector<double>{0.0, -0.0, -1.5, 65504.0, 65520.0, 1e6, 6e-8, 1e-40, 1e-300, 3.0});
}

FImage MakeRandomPicture(FChance& Chance, int Width, int Height)
{
	FImage Picture = MakeWall(Width, Height, Chance.Scale(0.01, 4.0), NumChannels);
	const double Hard = Chance.Is(0.3) ? Chance.Scale(1e-5, 0.02) : 0.0, Bright = Chance.Scale(1e-4, 0.05);
	const bool bMoves = Chance.Is(0.5), bToon = Chance.Is(0.6), bMask = Chance.Is(0.4), bGlass = Chance.Is(0.3);
	const double Edge = Chance.Between(0.0, Width), Slope = Chance.Between(0.0, 2.0 / Height);
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const bool bInside = X + Y * 0.3 < Edge;
			for (int Channel = Red; Channel <= Blue; ++Channel)
			{
				double& Light = At(Picture, X, Y, Channel);
				Light *= Chance.Between(0.5, 1.5) + Slope * Y;
				Light = Chance.Is(Bright) ? Chance.Scale(1.0, 500.0) : Light;
				Light = Chance.Is(Hard) ? MakeHardLight(Chance) : Light;
			}
			At(Picture, X, Y, Depth) = bInside ? 2.0 + Slope : 20.0 + X;
			At(Picture, X, Y, VelocityX) = bMoves && bInside ? Chance.Between(-8.0, 8.0) : 0.0;
			At(Picture, X, Y, VelocityY) = bMoves && bInside ? 3.0 : 0.0;
			At(Picture, X, Y, ShadingModel) = bToon && bInside ? Toon : Lit;
			At(Picture, X, Y, Mask) = bMask && bInside ? 1.0 : 0.0;
			At(Picture, X, Y, Mask + 1) = Chance.Is(0.3) ? Chance.Unit() : 1.0; // shadow.R
			At(Picture, X, Y, Mask + 3) = bGlass ? 0.2 : 0.0;                   // translucency.R
			At(Picture, X, Y, Mask + 6) = bGlass ? 0.5 : 1.0;                   // what it lets through
		}
	}
	return Picture;
}

double MakeNumber(FChance& Chance, const FSettingField& Field, double Default)
{
	const double Low = std::isfinite(Field.Range.UIMin)      ? Field.Range.UIMin
					   : std::isfinite(Field.Range.ClampMin) ? Field.Range.ClampMin
															 : std::min(0.0, 2.0 * Default);
	const double High = std::isfinite(Field.Range.UIMax)      ? Field.Range.UIMax
						: std::isfinite(Field.Range.ClampMax) ? Field.Range.ClampMax
															  : std::max({Low, 1.0, 2.0 * Default});
	switch (Chance.Whole(0, 5))
	{
	case 0:
		return Low;
	case 1:
		return High;
	default:
		return Chance.Between(Low, High);
	}
}

/** In its range as an editor shows it, or null where there is none to choose. */
FJson MakeSetting(FChance& Chance, const FSettingField& Field)
{
	switch (Field.Type)
	{
	case ESettingType::Bool:
		return Chance.Is(0.5);
	case ESettingType::Enum:
		return Field.EnumNames[Chance.Whole(0, Field.EnumNames.Num() - 1)];
	case ESettingType::Int:
		return static_cast<int>(std::lround(MakeNumber(Chance, Field, 1.0)));
	case ESettingType::Float:
		return MakeNumber(Chance, Field, 1.0);
	default:
		break;
	}
	if (Field.Type == ESettingType::ColorArray)
	{
		return {};
	}
	FJson Values = FJson::array();
	for (int32 Component = 0; Component < Field.GetNumComponents(); ++Component)
	{
		Values.push_back(MakeNumber(Chance, Field, 1.0));
	}
	return Values.empty() ? FJson() : Values;
}

/** Whether this setting calls for an effect. The others only shape effects. */
bool CallsForEffect(const std::string& Name)
{
	static const std::vector<std::string> Names = {"BloomIntensity", "BloomThreshold", "BloomToonIntensity",
		"MotionBlurAmount", "DepthOfFieldFstop", "LocalExposureHighlightContrastScale",
		"LocalExposureShadowContrastScale", "DiffusionFilterIntensity", "SoftFocusBlend", "GlowIntensity",
		"REDDofFocalDistance", "CharaGlowArea", "ToonShadowBlurIntensity", "UnityBloomIntensity",
		"DualKawaseBlurPassNum", "VignetteIntensity", "SceneFringeIntensity", "FilmGrainIntensity", "Sharpen"};
	return std::find(Names.begin(), Names.end(), Name) != Names.end();
}

FJson MakeSettings(FChance& Chance)
{
	const double Called = Chance.Between(0.0, 0.6), Shaped = Chance.Between(0.0, 0.15);
	FJson Settings = FJson::object();
	for (const FSettingField& Field : GetSettingFields())
	{
		if (Chance.Is(CallsForEffect(Field.Name) ? Called : Shaped))
		{
			const FJson Value = MakeSetting(Chance, Field);
			if (!Value.is_null())
			{
				Settings[Field.Name] = Value;
			}
		}
	}
	return Settings;
}

FJson MakeParameter(FChance& Chance, const FParameterSpec& Spec)
{
	const double Low = std::max(Spec.Min, -10.0), High = std::min(Spec.Max, 40.0);
	switch (Spec.Kind)
	{
	case EParameterKind::Number:
		return Chance.Between(Low, High);
	case EParameterKind::Integer:
		return Chance.Whole(static_cast<int>(Low), static_cast<int>(High));
	case EParameterKind::Bool:
		return Chance.Is(0.5);
	case EParameterKind::Text:
		return Spec.Choices.empty() ? FJson() : FJson(Chance.Of(Spec.Choices));
	case EParameterKind::Color:
		return {Chance.Unit(), Chance.Unit(), Chance.Unit(), 1};
	}
	return {};
}

/** Inserted passes with all inputs that they ask for. */
FJson MakePasses(FChance& Chance, int Num)
{
	FJson Passes = FJson::array();
	while (static_cast<int>(Passes.size()) < Num)
	{
		const FPassFactory& Factory = *Chance.Of(GetPassFactories());
		FJson Pass = {{"type", Factory.Type}, {"at", Chance.Of(std::vector<std::string>{"SSRInput", "MotionBlur",
														 "Tonemap", "FXAA", "VisualizeDepthOfField"})}};
		for (const FPassInputSpec& Input : Factory.Inputs)
		{
			if (Input.Default.empty())
			{
				Pass["inputs"][Input.Name] = "SceneColor";
			}
		}
		for (const FParameterSpec& Spec : Factory.Parameters)
		{
			const FJson Value = Chance.Is(0.5) ? MakeParameter(Chance, Spec) : FJson();
			if (!Value.is_null())
			{
				Pass["parameters"][Spec.Name] = Value;
			}
		}
		Passes.push_back(Pass);
	}
	return Passes;
}

FJson MakeRect(FChance& Chance, int MinX, int MaxX, int Height)
{
	const int Left = Chance.Whole(MinX, MaxX - 1), Top = Chance.Whole(0, Height - 1);
	return {Left, Top, Chance.Whole(Left + 1, MaxX), Chance.Whole(Top + 1, Height)};
}

void AddViews(FChance& Chance, int Width, int Height, FJson& Config)
{
	FJson View = FJson::object();
	if (Chance.Is(0.6))
	{
		View["exposure"] = Chance.Is(0.5) ? FJson("auto") : FJson(Chance.Scale(0.01, 100.0));
	}
	if (Chance.Is(0.4))
	{
		View["preExposure"] = Chance.Is(0.2) ? FJson("auto") : FJson(Chance.Scale(1e-3, 1e3));
	}
	if (Chance.Is(0.1) && Width > 1)
	{
		const int Middle = Chance.Whole(1, Width - 1);
		FJson Right = View;
		View["rect"] = MakeRect(Chance, 0, Middle, Height);
		Right["rect"] = MakeRect(Chance, Middle, Width, Height);
		Config["views"] = {View, Right};
		return;
	}
	if (Chance.Is(0.4))
	{
		View["rect"] = MakeRect(Chance, 0, Width, Height);
	}
	Config["view"] = View;
}

FJson MakeScene(FChance& Chance)
{
	FJson Scene = {{"file", "scene.exr"}};
	if (Chance.Is(0.4))
	{
		Scene["padding"] = {Chance.Whole(0, 40), Chance.Whole(0, 40), Chance.Whole(0, 40), Chance.Whole(0, 40)};
	}
	return Scene;
}

FJson MakeVariables(FChance& Chance)
{
	FJson Variables = FJson::object();
	for (const char* Effect : {"ToonBloom", "ToonShadowBlur", "DualKawase", "UnityBloom", "RED"})
	{
		if (Chance.Is(0.3))
		{
			Variables[std::string("r.") + Effect + ".AsPrinted"] = 1;
		}
	}
	if (Chance.Is(0.3))
	{
		Variables["r.AntiAliasingMethod"] = 1;
	}
	if (Chance.Is(0.2))
	{
		Variables["r.PostProcessing.PreferCompute"] = 1;
	}
	if (Chance.Is(0.2))
	{
		Variables["r.Drydock.Storage"] = Chance.Whole(1, 2);
	}
	return Variables;
}

} // namespace

FRandomFrame MakeRandomChain(uint32_t Seed)
{
	FChance Chance(Seed);
	const int Width = static_cast<int>(Chance.Scale(1.0, 1201.0)), Height = static_cast<int>(Chance.Scale(1.0, 1201.0));
	FJson Config = {{"engine", "5." + std::to_string(Chance.Whole(1, 8))}, {"scene", MakeScene(Chance)}};
	if (Chance.Is(0.1))
	{
		Config["scene"]["screenPercentage"] = Chance.Scale(25.0, 150.0);
	}
	AddViews(Chance, Width, Height, Config);
	Config["cvars"] = MakeVariables(Chance);
	Config["volumes"] = {{{"name", "All"}, {"bUnbound", true}, {"Settings", MakeSettings(Chance)}}};
	if (Chance.Is(0.5))
	{
		Config["passes"] = MakePasses(Chance, Chance.Whole(1, 4));
	}
	if (Chance.Is(0.3))
	{
		Config["extensions"] = {{{"type", "DualKawaseBlur"}, {"pass", Chance.Is(0.5) ? "MotionBlur" : "Tonemap"},
			{"Offset", Chance.Between(0.0, 3.0)}, {"PassNum", Chance.Whole(0, 5)}}};
	}
	// CharaGlow's native box is its shader's to within a bound (BoxSum.h), which the halfs of native storage do not
	// show.
	if (Config.dump().find("CharaGlow") != std::string::npos)
	{
		Config["cvars"].erase("r.Drydock.Storage");
	}
	return {MakeRandomPicture(Chance, Width, Height), AllChannels, Config.dump()};
}

FRandomFrame MakeFoolingFrame(uint32_t Seed)
{
	enum ETarget // the gate that is to be fooled
	{
		ToonTexels,
		MaskTexels,
		Motion,
		Brightness,
		Overflow, // of what is stored
		Num,
	};
	FChance Chance(Seed);
	const auto Pick = [&](const std::vector<double>& Values)
	{
		return Chance.Of(Values);
	};
	const int Target = Chance.Whole(0, Num - 1);
	const int Width = Chance.Whole(1, 96), Height = Chance.Whole(1, 64);
	const bool bRect = Width > 2 && Height > 2 && Chance.Is(0.5); // one texel lies around it
	const double Threshold = Target == Overflow ? Pick({2.0, 100.0}) : Pick({0.0, 0.18, 0.5, 1.0, 2.0});
	const double PreExposure = Target == Overflow ? Pick({1000.0, 3e5}) : Pick({1.0, 1.0, 0.25, 3.0, 1e-4});
	const double Exposure = Target == Overflow ? Pick({1.0, 1.0, 1e-3}) : Pick({1.0, 0.1, 30.0});
	const std::vector<double> Weights = {1.0, 1e-40, 6e-8, 1e-300, -0.0, 0.001, 1.0 / 512.0};
	const double Exact = Threshold / Exposure;
	const double Most = 65504.0 / PreExposure; // that a half holds
	const std::vector<double> Lights =
		Target == Overflow ? std::vector<double>{Most, Most * 1.0002, Most * 1.0003, Most * 1.1, Most * 0.999}
						   : std::vector<double>{Exact, std::nextafter(Exact, 1e9), Exact * 1.0005, Exact * 1.09,
								 Exact * 1.11, -Exact, 1e-40, Most * 1.1};
	// Translucency may brighten every pixel, so that some gates stay open.
	FImage Picture = MakeWall(Width, Height, Target >= Brightness ? 0.0 : Pick({0.0, -0.0, 0.1, 6e-8}),
		Chance.Is(0.2) ? NumChannels : NumWithoutTranslucency);
	for (int Spot = Chance.Whole(1, 3); Spot > 0; --Spot)
	{
		// A border as often as the middle.
		const int X = Chance.Is(0.5) ? Chance.Whole(0, Width - 1) : Chance.Is(0.5) ? (bRect ? 1 : 0) : Width - 1;
		const int Y = Chance.Is(0.5) ? Chance.Whole(0, Height - 1) : Chance.Is(0.5) ? 0 : Height - 1;
		switch (Target)
		{
		case ToonTexels:
			At(Picture, X, Y, ShadingModel) = Toon;
			At(Picture, X, Y, Red) = Pick(Lights);
			break;
		case MaskTexels:
			At(Picture, X, Y, Mask) = Pick(Weights);
			break;
		case Motion:
			At(Picture, X, Y, Chance.Is(0.5) ? VelocityX : VelocityY) = Pick(Weights);
			break;
		default:
			At(Picture, X, Y, Chance.Whole(Red, Blue)) = Pick(Lights);
			At(Picture, X, Y, ShadingModel) = Chance.Is(0.5) ? Toon : Lit;
		}
	}
	FJson Config = {{"engine", "5." + std::to_string(Chance.Whole(1, 8))}, {"scene", {{"file", "scene.exr"}}}};
	if (Chance.Is(0.5))
	{
		Config["scene"]["padding"] = Chance.Whole(1, 5);
	}
	Config["view"] = {{"preExposure", PreExposure}, {"exposure", Exposure}};
	if (bRect)
	{
		Config["view"]["rect"] = {1, 1, Width - 1, Height - 1};
	}
	if (Chance.Is(0.2))
	{
		Config["cvars"] = {{"r.PostProcessing.PreferCompute", 1}};
	}
	// The target's own effect, and now and then others.
	FJson Settings = {{"BloomIntensity", Pick({1.0, 4.0, 1e-30})},
		{"BloomThreshold", Target < Brightness && Chance.Is(0.5) ? -1.0 : Threshold}, {"MotionBlurTargetFPS", 0}};
	const auto Call = [&](const char* Setting, bool bOwn, const std::vector<double>& Values)
	{
		Settings[Setting] = bOwn || Chance.Is(0.1) ? Pick(Values) : 0.0;
	};
	if (Target == ToonTexels || Chance.Is(0.1))
	{
		Settings["BloomToonIntensity"] = Pick({0.0, 0.1, 0.999999, 1.0, 3.0});
	}
	Call("ToonShadowBlurIntensity", Target == ToonTexels, {1.0, 0.3, 1e-30});
	Call("CharaGlowArea", Target == MaskTexels, {3.0, 0.01, 20.0});
	Call("MotionBlurAmount", Target == Motion, {0.5, 1.0, 1e-30});
	Call("UnityBloomIntensity", false, {0.2});
	Call("DualKawaseBlurPassNum", false, {1.0});
	Call("GlowIntensity", false, {0.3});
	Config["volumes"] = {{{"name", "All"}, {"bUnbound", true}, {"Settings", Settings}}};
	return {Picture, {AllChannels.begin(), AllChannels.begin() + Picture.NumChannels}, Config.dump()};
}

FRandomScene::FRandomScene(FRandomFrame InFrame)
	: Frame(std::move(InFrame))
	, Folder(Frame.Picture, Frame.Channels)
{
	std::ofstream(Folder.Path / "random.json") << Frame.Config;
}

FRunResult FRandomScene::Run(const std::vector<std::string>& Variables, bool bNoSkip) const
{
	FRunOptions Options;
	Options.ConfigFile = (Folder.Path / "random.json").string();
	Options.ConfigText = Frame.Config;
	Options.Variables = Variables;
	Options.bNoSkip = bNoSkip;
	return RunConfig(Options);
}

} // namespace Stability
