// The output device out of its console variables, its format and its encoding's name. Source: engine file
// PostProcessTonemap.cpp (meaning of the variables).
#include "Tonemap/TonemapOutputDevice.h"

#include "HAL/IConsoleManager.h"

namespace
{

TAutoConsoleVariable<float> CVarTonemapperGamma(TEXT("r.TonemapperGamma"), 0.0f,
	TEXT("0: the sRGB or Rec.709 curve (default); above 0: a power of 1 over this in its place, at least 1."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarOutputDevice(TEXT("r.HDR.Display.OutputDevice"), 0,
	TEXT(
		"0: sRGB (default). 1: Rec.709. 2: explicit gamma. 3, 4: ACES 1000, 2000 nits, ST 2084. 5, 6: the same, scRGB. "
		"7: linear EXR. 8: linear, no tone curve. 9: linear with the film curve."),
	ECVF_RenderThreadSafe);

constexpr float DisplayGamma = 2.2f;

} // namespace

FTonemapperOutputDeviceParameters GetTonemapperOutputDeviceParameters()
{
	const float TonemapperGamma = CVarTonemapperGamma.GetValueOnRenderThread();
	const int32 Device =
		FMath::Clamp(CVarOutputDevice.GetValueOnRenderThread(), 0, static_cast<int32>(EDisplayOutputFormat::MAX) - 1);

	FTonemapperOutputDeviceParameters Parameters;
	Parameters.InverseGamma =
		FVector3f(1.0f / DisplayGamma, 2.2f / DisplayGamma, 1.0f / FMath::Max(TonemapperGamma, 1.0f));
	Parameters.OutputDevice = static_cast<EDisplayOutputFormat>(Device);
	if (TonemapperGamma > 0.0f && Parameters.OutputDevice <= EDisplayOutputFormat::SDR_Rec709)
	{
		Parameters.OutputDevice = EDisplayOutputFormat::SDR_ExplicitGammaMapping;
	}
	return Parameters;
}

namespace Drydock
{

EPixelFormat GetDisplayFormat(EDisplayOutputFormat OutputDevice)
{
	switch (OutputDevice)
	{
	case EDisplayOutputFormat::HDR_ACES_1000nit_ST2084:
	case EDisplayOutputFormat::HDR_ACES_2000nit_ST2084:
		return PF_A2B10G10R10;
	case EDisplayOutputFormat::HDR_LinearEXR:
		return PF_A32B32G32R32F;
	case EDisplayOutputFormat::HDR_ACES_1000nit_ScRGB:
	case EDisplayOutputFormat::HDR_ACES_2000nit_ScRGB:
	case EDisplayOutputFormat::HDR_LinearNoToneCurve:
	case EDisplayOutputFormat::HDR_LinearWithToneCurve:
		return PF_FloatRGBA;
	default:
		return PF_B8G8R8A8;
	}
}

const char* GetEncodingName(EDisplayOutputFormat OutputDevice)
{
	static const char* const Names[] = {"sRGB", "Rec.709", "power", "ST 2084, Rec.2020", "ST 2084, Rec.2020",
		"scRGB: linear Rec.709, 1 is 80 nits", "scRGB: linear Rec.709, 1 is 80 nits",
		"linear Rec.709, graded, no tone curve", "linear Rec.709, graded, no tone curve",
		"linear Rec.709, display-referred"};
	static_assert(std::size(Names) == static_cast<size_t>(EDisplayOutputFormat::MAX));
	return Names[static_cast<size_t>(OutputDevice)];
}

} // namespace Drydock
