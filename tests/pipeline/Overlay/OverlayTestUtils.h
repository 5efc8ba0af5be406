// Files of engine overlays for tests.
#pragma once

#include <string>

namespace OverlayTest
{

inline const std::string Renderer = "Engine/Source/Runtime/Renderer/Private/PostProcess/";
inline const std::string SceneHeader = "Engine/Source/Runtime/Engine/Classes/Engine/Scene.h";
inline const std::string SceneSource = "Engine/Source/Runtime/Engine/Private/Scene.cpp";
inline const std::string SceneView = "Engine/Source/Runtime/Engine/Private/SceneView.cpp";

/** A header that adds a colour, an enum and a number, beside a setting that is there already. */
inline const std::string DuskHeader = R"(
UENUM(BlueprintType)
enum class EDuskMode : uint8
{
	Off UMETA(DisplayName = "Off, as ever"), // no dusk
	Warm,
	Cold,
	EDuskMode_MAX UMETA(Hidden),
};

struct FPostProcessSettings
{
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category=Overrides, meta=(PinHiddenByDefault))
	uint8 bOverride_DuskTint:1;
	uint8 bOverride_DuskMode:1;
	uint8 bOverride_DuskAmount:1;
	uint8 bOverride_BloomIntensity:1;

	UPROPERTY(interp, Category="Lens|Dusk", meta=(editcondition = "bOverride_DuskTint", DisplayName = "Tint"))
	FLinearColor DuskTint;
	UPROPERTY(EditAnywhere, meta=(editcondition = "bOverride_DuskMode"))
	TEnumAsByte<enum EDuskMode> DuskMode;
	UPROPERTY(interp, meta=(ClampMin = "0.0", UIMax = "1.5", editcondition = "bOverride_DuskAmount"))
	float DuskAmount;
};
)";

inline const std::string DuskSource = R"(
FPostProcessSettings::FPostProcessSettings()
{
	Other.DuskAmount = 9.0f; // another object's
	DuskTint = FLinearColor(1.0f, 0.5f, 0.25f);
	DuskAmount = 0.25f;
}
)";

inline const std::string DuskView = "LERP_PP(DuskTint);\nSET_PP( DuskMode );\nLERP_PP(DuskAmountElse);\n";

} // namespace OverlayTest
