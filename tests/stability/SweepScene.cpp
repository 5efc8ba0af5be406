// The small scene and the two frames of the sweep.
#include "SweepScene.h"

using namespace Drydock;

namespace Stability
{

namespace
{

constexpr int Width = 32;
constexpr int Height = 18;

const std::vector<std::string> Channels = {"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z",
	"velocity.X", "velocity.Y", "basecolor.R", "basecolor.G", "basecolor.B", "shadingmodel.ID", "custommask.B",
	"shadow.R", "shadow.G", "translucency.R", "translucency.G", "translucency.B", "translucency.A", "customdepth.Z",
	"customstencil.ID"};

/** A ramp with a light, near and far, still and moving, toon and not, in shadow and lit, behind glass and not. */
FImage MakePicture()
{
	FImage Picture{Width, Height, static_cast<int>(Channels.size()), {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const double Ramp = X == 9 && Y == 5 ? 40.0 : 0.02 + X / 16.0 + Y / 64.0;
			const double Glass = X >= 24 ? 0.5 : 1.0;
			Picture.Values.insert(Picture.Values.end(),
				{Ramp, 0.7 * Ramp, 0.4 * Ramp, 1.0, X < 16 ? 2.0 + 0.2 * Y : X - 11.0, 0.0, -1.0, 0.0,
					Y >= 9 ? 6.0 : 0.0, X >= 20 ? 3.0 : 0.0, 0.5, 0.4, 0.3, X < 12 ? 8.0 : 1.0,
					X >= 8 && X < 14 ? 1.0 : 0.0, (X + Y) % 5 == 0 ? 0.2 : 1.0, 1.0, 0.1 * (1.0 - Glass),
					0.2 * (1.0 - Glass), 0.0, Glass, X < 6 ? 2.0 : 0.0, X < 6 ? 1.0 : 0.0});
		}
	}
	return Picture;
}

constexpr const char* AllOn = R"(
	"MotionBlurAmount": 0.5, "MotionBlurTargetFPS": 0, "MotionBlurMax": 20,
	"DepthOfFieldFocalDistance": 350, "DepthOfFieldFstop": 2, "DepthOfFieldSensorWidth": 1000,
	"DepthOfFieldDepthBlurRadius": 200, "DepthOfFieldDepthBlurAmount": 0.01, "LocalExposureHighlightContrastScale": 0.8,
	"LocalExposureShadowContrastScale": 0.8, "LocalExposureDetailStrength": 1.2, "BloomThreshold": 0.5, "BloomConvolutionPreFilterMin": 0.5,
	"BloomConvolutionPreFilterMax": 100, "BloomConvolutionPreFilterMult": 3,
	"BloomToonIntensity": 0.3, "BloomDirtMask": "Builtin/Disc", "BloomDirtMaskIntensity": 1,
	"ToonShadowBlurIntensity": 1, "DiffusionFilterIntensity": 0.3, "DiffusionFilterSepia": 0.2, "SoftFocusBlend": 0.3,
	"SoftFocusSaturation": 1.1, "GlowIntensity": 0.2, "CharaGlowArea": 3, "REDDofFocalDistance": 400, "REDDofNearBlurSize": 12, "REDDofFarBlurSize": 12,
	"UnityBloomIntensity": 0.2, "UnityBloomSoftKnee": 0.3, "DualKawaseBlurPassNum": 1, "WhiteTemp": 6000,
	"ColorSaturation": [1.1, 1.1, 1.1, 1], "ColorContrastShadows": [1.1, 1, 1, 1], "ColorGainHighlights": [1.2, 1, 1, 1],
	"VignetteIntensity": 0.4, "SceneFringeIntensity": 2, "FilmGrainIntensity": 0.3,
	"FilmGrainIntensityShadows": 0.5, "FilmGrainIntensityHighlights": 0.2, "Sharpen": 0.3)";

std::string MakeConfig(ESweepFrame Frame)
{
	const bool bPrinted = Frame == ESweepFrame::Printed;
	// RED as printed gains so much light that nothing of this scene stays finite.
	const std::string Variables =
		std::string(R"("r.Drydock.Threads": 1, "r.AntiAliasingMethod": 1, "r.DOF.Kernel.MaxForegroundRadius": 0.2,
		"r.DOF.Kernel.MaxBackgroundRadius": 0.2)") +
		(bPrinted ? R"(, "r.ToonBloom.AsPrinted": 1, "r.ToonShadowBlur.AsPrinted": 1, "r.DualKawase.AsPrinted": 1,
		"r.UnityBloom.AsPrinted": 1)"
				  : "");
	const std::string Own = bPrinted ? R"("BloomMethod": "BM_FFT", "AutoExposureMethod": "AEM_Basic")"
									 : R"("BloomMethod": "BM_SOG", "AutoExposureMethod": "AEM_Histogram")";
	const std::string Exposure = Frame == ESweepFrame::Manual ? "1" : R"("auto")";
	return R"({"scene": {"file": "scene.exr"}, "view": {"exposure": )" + Exposure + R"(}, "cvars": {)" + Variables +
		   R"(}, "volumes": [{"name": "All", "bUnbound": true, "Settings": {)" + Own + "," + AllOn + "}}]}";
}

} // namespace

const char* ToString(ESweepFrame Frame)
{
	return Frame == ESweepFrame::Printed ? "printed" : Frame == ESweepFrame::Manual ? "manual" : "corrected";
}

FSweepScene::FSweepScene()
	: Folder(MakePicture(), Channels)
{
}

FRunResult FSweepScene::Run(
	ESweepFrame Frame, const std::vector<std::string>& Settings, const std::vector<std::string>& Variables) const
{
	FRunOptions Options;
	Options.ConfigFile = (Folder.Path / "sweep.json").string();
	Options.ConfigText = MakeConfig(Frame);
	Options.Settings = Settings;
	Options.Variables = Variables;
	return RunConfig(Options);
}

} // namespace Stability
