// Settings that an overlay's Scene.h adds: types, defaults, ranges, rules, and what cannot be added.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Overlay/OverlayErrors.h"
#include "Overlay/OverlaySettings.h"
#include "OverlayTestUtils.h"

using namespace Drydock;
using namespace OverlayTest;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

FOverlaySettings ReadSettings(const std::string& Header, std::vector<FDiagnostic>& Diagnostics)
{
	return ReadOverlaySettings(
		{"Scene.h", Header}, {"Scene.cpp", DuskSource}, {"SceneView.cpp", DuskView}, Diagnostics);
}

} // namespace

TEST(OverlaySettings, AreReadWithDefaultsRangesAndRules)
{
	std::vector<FDiagnostic> Diagnostics;
	const FOverlaySettings Found = ReadSettings(DuskHeader, Diagnostics);
	EXPECT_TRUE(Diagnostics.empty());
	ASSERT_EQ(3u, Found.Settings.size()) << "BloomIntensity is there already";
	const FOverlaySetting& Tint = Found.Settings[0];
	EXPECT_EQ("DuskTint", Tint.Name);
	EXPECT_EQ("FLinearColor", Tint.Type);
	EXPECT_EQ("FLinearColor(1.0f, 0.5f, 0.25f)", Tint.Default);
	EXPECT_EQ("Lens|Dusk", Tint.Category);
	EXPECT_EQ("Tint", Tint.Doc);
	EXPECT_EQ("Lerp", Tint.Blend);
	const FOverlaySetting& Mode = Found.Settings[1];
	EXPECT_EQ("EDuskMode", Mode.Type);
	EXPECT_EQ("", Mode.Default);
	EXPECT_EQ("Set", Mode.Blend);
	EXPECT_THAT(Mode.EnumNames, ElementsAre("Off", "Warm", "Cold"));
	EXPECT_THAT(Found.EnumTexts, ElementsAre("enum class EDuskMode : uint8\n{ Off, Warm, Cold, EDuskMode_MAX, };"));
	const FOverlaySetting& Amount = Found.Settings[2];
	EXPECT_EQ("0.25f", Amount.Default);
	EXPECT_EQ("0.0", Amount.Min);
	EXPECT_EQ("1.5", Amount.Max);
	EXPECT_EQ("", Amount.Blend) << "a longer name's line is not its own";
}

TEST(OverlaySettings, MistakesNameTheLine)
{
	std::vector<FDiagnostic> Diagnostics;
	ReadSettings("uint8 bOverride_Alone:1;\nuint8 bOverride_Mesh:1;\nUPROPERTY()\nUStaticMesh* Mesh;\n", Diagnostics);
	ASSERT_EQ(2u, Diagnostics.size());
	std::vector<FDiagnostic> Notes;
	ReadSettings("struct FPostProcessSettings\n{\n\tUPROPERTY(interp)\n\tfloat Alone = 1.0f;\n\tUPROPERTY()\n"
				 "\tfloat BloomIntensity;\n};\nUPROPERTY()\nint Elsewhere;\n",
		Notes);
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(ESeverity::Note, Notes[0].Severity);
	EXPECT_EQ("Alone becomes no setting: it has no bit bOverride_Alone", Notes[0].Message);
	EXPECT_EQ(ErrorOverlaySetting, Diagnostics[0].Code);
	EXPECT_EQ(1, Diagnostics[0].Line);
	EXPECT_THAT(Diagnostics[0].Message, HasSubstr("bOverride_Alone has no UPROPERTY Alone"));
	EXPECT_EQ(4, Diagnostics[1].Line);
	EXPECT_THAT(Diagnostics[1].Message, HasSubstr("the type of Mesh must be one of FLinearColor, FVector2D"));
}
