// Which effects the settings call for. Source: engine PostProcess/PostProcessing.cpp (conditions); wording is
// drydock's.
#include "Effects/EffectDecisions.h"

#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessToonBloom.h"
#include "Effects/ArticleEffects.h"
#include "Effects/ContentGates.h"
#include "Effects/ExposureDecisions.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "HAL/IConsoleManager.h"
#include "Lens/DiaphragmDOF.h"
#include "Lens/PostProcessMotionBlur.h"
#include "Screen/PostProcessAA.h"
#include "Screen/PostProcessUpscale.h"
#include "Text/TextFormat.h"
#include "Tonemap/ColorGrading.h"
#include "Tonemap/PostProcessCombineLUTs.h"

#include <algorithm>
#include <utility>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarAntiAliasingMethod(TEXT("r.AntiAliasingMethod"), 0,
	TEXT("0: off (default). 1: FXAA. 2 TAA, 3 MSAA, 4 TSR: not simulated."), ECVF_RenderThreadSafe);

/** ": ShowFlag.Bloom is off", or nothing. */
std::string GateText(const FChainSettings& Chain, const char* Setting)
{
	const auto Found = std::find_if(
		Chain.Gates.begin(), Chain.Gates.end(), [&](const FSettingGate& Gate) { return Gate.Setting == Setting; });
	return Found == Chain.Gates.end() ? "" : ": " + Found->Reason;
}

/** How an active bloom is made, and why not by convolution where that is asked for. */
std::string BloomMethodText(const FFinalPostProcessSettings& Settings)
{
	if (Settings.BloomMethod != BM_FFT)
	{
		return "";
	}
	const std::string Obstacle = GetFFTBloomObstacle(Settings, true);
	if (!Obstacle.empty())
	{
		return "; BM_FFT is asked for, but " + Obstacle + ": the Gaussian sum runs";
	}
	return "; by convolution (BM_FFT), BloomConvolutionScatterDispersion " +
		   NumberText(Settings.BloomConvolutionScatterDispersion) +
		   (Settings.BloomThreshold > -1.0f ? "; it reads no threshold" : "");
}

FEffectDecision DecideBloom(const FChainSettings& Chain, bool bToonBloom)
{
	FEffectDecision Bloom{"Bloom", false, false, ""};
	const float Intensity = Chain.Settings.BloomIntensity;
	if (!Chain.ShowFlags.PostProcessing)
	{
		Bloom.Reason = "ShowFlag.PostProcessing is off";
	}
	else if (!(Intensity > 0.0f))
	{
		Bloom.Reason = "BloomIntensity is " + NumberText(Intensity) + GateText(Chain, "BloomIntensity");
	}
	else if (IsToonBloomMaskVisualized())
	{
		Bloom.Reason = "r.ToonBloom.VisualizeMask shows the mask in its place";
	}
	else
	{
		Bloom.bActive = true;
		const float Threshold = Chain.Settings.BloomThreshold;
		const bool bLocalExposure = DecideLocalExposure(Chain).bActive && IsLocalExposureAppliedToBloom();
		Bloom.Reason = "BloomIntensity is " + NumberText(Intensity) + ", BloomThreshold " + NumberText(Threshold);
		if (!(Threshold > -1.0f))
		{
			Bloom.Reason += bToonBloom       ? ": the setup pass is there for the toon's factor"
							: bLocalExposure ? ": the setup pass is there for local exposure"
											 : ": the setup pass is not needed";
		}
		Bloom.Reason += BloomMethodText(Chain.Settings);
		if (const std::string Dark = FindNothingBright(Chain); !Dark.empty())
		{
			return {"Bloom", false, true, Dark, true};
		}
	}
	Bloom.bConfigured = Bloom.bActive || (Chain.Settings.bOverride_BloomIntensity && !(Intensity > 0.0f) &&
											 !GateText(Chain, "BloomIntensity").empty());
	return Bloom;
}

FEffectDecision DecideDepthOfField(const FChainSettings& Chain)
{
	const FFinalPostProcessSettings& Settings = Chain.Settings;
	const bool bConfigured = std::any_of(Chain.NamedSettings.begin(), Chain.NamedSettings.end(),
		[](const std::string& Setting) { return Setting.starts_with("DepthOfField"); });
	const std::string Values = "DepthOfFieldFocalDistance is " + NumberText(Settings.DepthOfFieldFocalDistance) +
							   ", DepthOfFieldFstop " + NumberText(Settings.DepthOfFieldFstop);
	if (!Chain.ShowFlags.PostProcessing || !Chain.ShowFlags.DepthOfField)
	{
		return {"DepthOfField", false, bConfigured,
			std::string("ShowFlag.") + (Chain.ShowFlags.PostProcessing ? "DepthOfField" : "PostProcessing") +
				" is off"};
	}
	const bool bEnabled = DiaphragmDOF::IsEnabled(Settings);
	return {"DepthOfField", bEnabled, bEnabled || bConfigured,
		Values + (bEnabled ? "; a simplification of the engine's" : ": nothing is focused")};
}

/** Unlike the engine, whose default amount is 0.5: a rendered frame may hold motion blur already, so it has to be
 * called for. */
FEffectDecision DecideMotionBlur(const FChainSettings& Chain)
{
	const FFinalPostProcessSettings& Settings = Chain.Settings;
	const bool bNamed = std::any_of(Chain.NamedSettings.begin(), Chain.NamedSettings.end(),
		[](const std::string& Setting) { return Setting.starts_with("MotionBlur"); });
	const std::string Values = "MotionBlurAmount is " + NumberText(Settings.MotionBlurAmount) + ", MotionBlurMax " +
							   NumberText(Settings.MotionBlurMax);
	const auto No = [bNamed](const std::string& Reason)
	{
		return FEffectDecision{"MotionBlur", false, bNamed, Reason};
	};
	if (!bNamed)
	{
		return No("not called for: nothing in the config sets MotionBlurAmount, Max or TargetFPS");
	}
	if (!Chain.ShowFlags.PostProcessing || !Chain.ShowFlags.MotionBlur)
	{
		return No(
			std::string("ShowFlag.") + (Chain.ShowFlags.PostProcessing ? "MotionBlur" : "PostProcessing") + " is off");
	}
	if (GetMotionBlurQuality() == EMotionBlurQuality::Off)
	{
		return No("r.MotionBlurQuality is 0");
	}
	const bool bBlurs = Settings.MotionBlurAmount > 0.0f && Settings.MotionBlurMax > 0.0f;
	return bBlurs ? FEffectDecision{"MotionBlur", true, true, Values} : No(Values);
}

FEffectDecision DecideDualKawase(const FChainSettings& Chain)
{
	const int32 PassNum = Chain.Settings.DualKawaseBlurPassNum;
	const bool bConfigured = Chain.bDualKawaseExtension || PassNum > 0;
	if (bConfigured && !Chain.ShowFlags.PostProcessing)
	{
		return {"DualKawaseBlur", false, true, "ShowFlag.PostProcessing is off"};
	}
	const std::string Setting = "DualKawaseBlurPassNum is " + std::to_string(PassNum);
	return {"DualKawaseBlur", bConfigured, bConfigured,
		Chain.bDualKawaseExtension ? "a view extension makes it" + (PassNum > 0 ? "; " + Setting : std::string())
		: PassNum > 0 ? Setting + ", DualKawaseBlurOffset " + NumberText(Chain.Settings.DualKawaseBlurOffset)
					  : Setting + ", and there is no such view extension"};
}

/** What becomes of an active toon bloom in the article's form. */
std::string AsPrintedText()
{
	if (!IsToonBloomAsPrinted())
	{
		return "";
	}
	return IsComputePreferred() ? "; as printed, and lost: the article patches the pixel shader only, and "
								  "r.PostProcessing.PreferCompute is 1"
								: "; as printed: one id for each half-resolution pixel";
}

FEffectDecision DecideToonBloom(const FChainSettings& Chain)
{
	const int32 Mode = GetToonBloomMode();
	const float Factor = Chain.Settings.BloomToonIntensity;
	const bool bThreshold = Chain.Settings.BloomThreshold > -1.0f;
	// A view extension that sets the final settings says so by the override bit.
	const bool bNamed = Chain.bToonBloomConfigured || Chain.Settings.bOverride_BloomToonIntensity;
	const FEffectDecision Bloom = DecideBloom(Chain, false);
	const std::string NoSetup = bThreshold
									? ""
									: "; without it the bloom setup pass is not in the graph (BloomThreshold is " +
										  NumberText(Chain.Settings.BloomThreshold) + ")";
	FEffectDecision Toon{"ToonBloom", false, bNamed || Mode > 0, ""};
	if (Mode == 0)
	{
		Toon.Reason = "r.ToonBloom is 0";
	}
	else if (Mode < 0 && !bNamed)
	{
		Toon.Reason = "not called for: nothing names BloomToonIntensity";
	}
	else if (!Bloom.bActive)
	{
		Toon.Reason = "there is no bloom to mask: " + Bloom.Reason;
	}
	else if (!(Factor > -1.0f))
	{
		Toon.Reason = "BloomToonIntensity is " + NumberText(Factor) + ": the setup pass takes values above -1";
	}
	else if (Mode < 0 && Factor == 1.0f && !Chain.bNoSkip)
	{
		Toon.Reason = "BloomToonIntensity is 1, which changes nothing";
	}
	else
	{
		Toon.bActive = true;
		Toon.Reason = "BloomToonIntensity is " + NumberText(Factor) +
					  (bThreshold ? "" : ": it brings the setup pass into the graph") + AsPrintedText();
	}
	Toon.Reason += Toon.bActive || !Bloom.bActive ? "" : NoSetup;
	return Toon;
}

FEffectDecision DecideAntiAliasing(const FChainSettings& Chain)
{
	const int32 Method = CVarAntiAliasingMethod.GetValueOnAnyThread();
	if (Method == 0)
	{
		return {"FXAA", false, false, "r.AntiAliasingMethod is 0"};
	}
	if (Method != 1)
	{
		return {"FXAA", false, true, "r.AntiAliasingMethod is " + std::to_string(Method) + ", which is not simulated"};
	}
	if (!Chain.ShowFlags.PostProcessing || !Chain.ShowFlags.AntiAliasing)
	{
		return {"FXAA", false, true,
			std::string("ShowFlag.") + (Chain.ShowFlags.PostProcessing ? "AntiAliasing" : "PostProcessing") +
				" is off"};
	}
	return {"FXAA", true, true,
		"r.AntiAliasingMethod is 1, r.FXAA.Quality " + std::to_string(static_cast<int32>(GetFXAAQuality()))};
}

FEffectDecision DecideTonemap(const FChainSettings& Chain)
{
	if (!Chain.ShowFlags.PostProcessing || !Chain.ShowFlags.Tonemapper)
	{
		return {"Tonemap", true, true,
			std::string("always; gamma only, no curve, bloom or lens: ShowFlag.") +
				(Chain.ShowFlags.PostProcessing ? "Tonemapper" : "PostProcessing") + " is off"};
	}
	const EDisplayOutputFormat Device = GetTonemapperOutputDeviceParameters().OutputDevice;
	std::string Reason = IsTonemapLUTUsed() ? "always; by the combined table" : "always; evaluated for each pixel";
	if (!MakeColorGrading(Chain.Settings).bNeutral)
	{
		Reason += ", with colour grading";
	}
	if (Device != EDisplayOutputFormat::SDR_sRGB)
	{
		Reason += std::string(", for ") + GetEncodingName(Device);
	}
	return {"Tonemap", true, true, Reason};
}

FEffectDecision DecideUpscale(const FChainSettings& Chain)
{
	if (Chain.ScreenPercentage == 100.0)
	{
		return {"Upscale", false, false, "scene.screenPercentage is 100"};
	}
	const std::string Percentage =
		"scene.screenPercentage is " + NumberText(static_cast<float>(Chain.ScreenPercentage));
	if (!Chain.ShowFlags.ScreenPercentage)
	{
		return {"Upscale", false, true, Percentage + ", but ShowFlag.ScreenPercentage is off"};
	}
	return {"Upscale", true, true,
		Percentage + ", r.Upscale.Quality " + std::to_string(static_cast<int32>(GetUpscaleMethod()))};
}

} // namespace

const FEffectDecision* FindEffect(const std::vector<FEffectDecision>& Effects, std::string_view Name)
{
	const auto Found = std::find_if(
		Effects.begin(), Effects.end(), [&](const FEffectDecision& Effect) { return Effect.Name == Name; });
	return Found == Effects.end() ? nullptr : &*Found;
}

FEffectDecision* FindEffect(std::vector<FEffectDecision>& Effects, std::string_view Name)
{
	return const_cast<FEffectDecision*>(FindEffect(std::as_const(Effects), Name));
}

bool IsEffectActive(const std::vector<FEffectDecision>& Effects, std::string_view Name)
{
	const FEffectDecision* const Effect = FindEffect(Effects, Name);
	return Effect != nullptr && Effect->bActive;
}

const std::vector<std::string>& GetEffectNames()
{
	static const std::vector<std::string> Names = {"Bloom", "ToonBloom", "LocalExposure", "Exposure", "MotionBlur",
		"DepthOfField", "RED", "REDDepthOfField", "CharaGlow", "ToonShadowBlur", "UnityBloom", "DualKawaseBlur",
		"Tonemap", "FXAA", "Upscale"};
	return Names;
}

bool IsComputePreferred()
{
	const IConsoleVariable* Compute =
		IConsoleManager::Get().FindConsoleVariable(TEXT("r.PostProcessing.PreferCompute"));
	return Compute != nullptr && Compute->GetInt() != 0;
}

double GetScreenPercentage(const FChainSettings& Chain)
{
	return Chain.ShowFlags.ScreenPercentage ? Chain.ScreenPercentage : 100.0;
}

std::vector<FEffectDecision> DecideEffects(const FChainSettings& Chain)
{
	std::vector<FEffectDecision> Decisions;
	FEffectDecision ToonBloom = DecideToonBloom(Chain);
	ApplyContentGate(Chain, ToonBloom); // before the others: bloom says whether its setup is there for it
	for (const std::string& Name : GetEffectNames())
	{
		FEffectDecision Decision{Name, false, false, "not built yet"};
		if (Name == "Bloom")
		{
			Decision = DecideBloom(Chain, ToonBloom.bActive);
		}
		else if (Name == "ToonBloom")
		{
			Decision = ToonBloom;
		}
		else if (Name == "Exposure")
		{
			Decision = DecideExposure(Chain);
		}
		else if (Name == "LocalExposure")
		{
			Decision = DecideLocalExposure(Chain);
		}
		else if (Name == "DepthOfField")
		{
			Decision = DecideDepthOfField(Chain);
		}
		else if (Name == "MotionBlur")
		{
			Decision = DecideMotionBlur(Chain);
		}
		else if (Name == "DualKawaseBlur")
		{
			Decision = DecideDualKawase(Chain);
		}
		else if (const std::optional<FEffectDecision> Article = DecideArticleEffect(Name, Chain))
		{
			Decision = *Article;
		}
		else if (Name == "Tonemap")
		{
			Decision = DecideTonemap(Chain);
		}
		else if (Name == "FXAA")
		{
			Decision = DecideAntiAliasing(Chain);
		}
		else if (Name == "Upscale")
		{
			Decision = DecideUpscale(Chain);
		}
		ApplyContentGate(Chain, Decision);
		Decisions.push_back(Decision);
	}
	return Decisions;
}

} // namespace Drydock
