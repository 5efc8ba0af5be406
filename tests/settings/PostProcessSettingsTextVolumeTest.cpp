// Copied actors as text: which volumes are in it, where they are, and what is written for the editor.
#include <gtest/gtest.h>

#include "PostProcessSettingsTextVolume.h"

using namespace Drydock;

namespace
{

struct FRead
{
	std::vector<FVolumeText> Volumes;
	std::vector<FDiagnostic> Diagnostics;
};

FRead Read(const std::string& Text)
{
	FRead Result;
	Result.Volumes = ReadVolumesText(Text, "clip.txt", Result.Diagnostics);
	return Result;
}

std::vector<FVolumeText> ReadClean(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_TRUE(Result.Diagnostics.empty()) << Result.Diagnostics[0].ToString();
	return Result.Volumes;
}

/** As the editor copies it: two volumes, one of them bounded, and a light between them. */
const std::string GMap = R"(Begin Map
   Begin Level
      Begin Actor Class=/Script/Engine.PostProcessVolume Name=PostProcessVolume_0 Archetype=/Script/Engine.PostProcessVolume'/Script/Engine.Default__PostProcessVolume'
         Begin Object Class=/Script/Engine.BrushComponent Name="BrushComponent0" Archetype=/Script/Engine.BrushComponent'/Script/Engine.Default__PostProcessVolume:BrushComponent0'
         End Object
         Begin Object Class=/Script/UnrealEd.CubeBuilder Name="CubeBuilder_0"
         End Object
         Begin Object Name="BrushComponent0"
            Brush=Model'"Model_0"'
            RelativeLocation=(X=100.000000,Y=-200.000000,Z=50.000000)
            RelativeRotation=(Pitch=0.000000,Yaw=45.000000,Roll=0.000000)
            RelativeScale3D=(X=3.000000,Y=2.000000,Z=0.500000)
         End Object
         Settings=(bOverride_BloomIntensity=True,BloomIntensity=1.200000)
         Priority=2.000000
         BlendRadius=50.000000
         BlendWeight=0.500000
         Brush=Model'"Model_0"'
         BrushComponent="BrushComponent0"
         RootComponent="BrushComponent0"
         ActorLabel="Stage \"left\""
      End Actor
      Begin Actor Class=/Script/Engine.PointLight Name=PointLight_1
         Begin Object Class=/Script/Engine.PointLightComponent Name="LightComponent0"
            Intensity=(oops
         End Object
      End Actor
      Begin Actor Class=/Script/Engine.PostProcessVolume Name=Base
         Settings=(bOverride_FilmToe=True,
            FilmToe=0.400000)
         bEnabled=False
         bUnbound=True
      End Actor
   End Level
Begin Surface
End Surface
End Map
)";

/** An actor whose brush has these objects and lines. */
std::string Actor(const std::string& Inside)
{
	return "Begin Actor Class=/Script/Engine.PostProcessVolume Name=A\n" + Inside + "Settings=()\nEnd Actor\n";
}

const FVolumeTextBox GDefaultBox;

} // namespace

TEST(VolumesText, EveryVolumeIsFoundAndNothingElse)
{
	const std::vector<FVolumeText> Volumes = ReadClean(GMap);
	ASSERT_EQ(2u, Volumes.size());
	EXPECT_EQ("Stage \"left\"", Volumes[0].Name);
	EXPECT_EQ("Base", Volumes[1].Name);
}

TEST(VolumesText, SettingsAreRead)
{
	const std::vector<FVolumeText> Volumes = ReadClean(GMap);
	EXPECT_EQ(1.2f, Volumes.at(0).Settings.Settings.BloomIntensity);
	EXPECT_EQ(0.4f, Volumes.at(1).Settings.Settings.FilmToe);
}

TEST(VolumesText, BlendingPropertiesAreRead)
{
	const FVolumeText Volume = ReadClean(GMap).at(0);
	EXPECT_EQ(2.0, Volume.Priority);
	EXPECT_EQ(50.0, Volume.BlendRadius);
	EXPECT_EQ(0.5, Volume.BlendWeight);
	EXPECT_TRUE(Volume.bEnabled);
	EXPECT_FALSE(Volume.bUnbound);
}

TEST(VolumesText, UnnamedPropertiesAreTheEnginesDefaults)
{
	const FVolumeText Volume = ReadClean(GMap).at(1);
	EXPECT_EQ(0.0, Volume.Priority);
	EXPECT_EQ(100.0, Volume.BlendRadius);
	EXPECT_EQ(1.0, Volume.BlendWeight);
	EXPECT_FALSE(Volume.bEnabled);
	EXPECT_TRUE(Volume.bUnbound);
	EXPECT_FALSE(Volume.Box);
}

TEST(VolumesText, TransformedCubeIsABox)
{
	// Half a side of the default cube is 100 cm.
	const FVolumeTextBox Box = ReadClean(GMap).at(0).Box.value();
	EXPECT_EQ((FVolumeTextBox{{100, -200, 50}, {300, 200, 50}, {0, 45, 0}}), Box);
}

TEST(VolumesText, BuildersSizeIsRead)
{
	EXPECT_EQ((FVolumeTextBox{{0, 0, 0}, {150, 100, 50}, {0, 0, 0}}),
		ReadClean(Actor("Begin Object Class=/Script/UnrealEd.CubeBuilder Name=\"CubeBuilder_3\"\nX=300.0\nZ=100.0\n"
						"End Object\n"))
			.at(0)
			.Box);
}

TEST(VolumesText, PolygonsOfABoxAreABox)
{
	// Corners (-10, 0, 0) and (10, 40, 20): centre (0, 20, 10), half sizes (10, 20, 10); moved by (5, 5, 5), z doubled.
	EXPECT_EQ((FVolumeTextBox{{5, 25, 25}, {10, 20, 20}, {0, 0, 0}}),
		ReadClean(Actor("Begin Object Name=\"BrushComponent0\"\nRelativeLocation=(X=5,Y=5,Z=5)\nRelativeScale3D=(Z=2)\n"
						"End Object\nBegin Brush Name=Model_0\nBegin PolyList\nBegin Polygon Item=Side\n"
						"Origin   -00010.000000,+00000.000000,+00000.000000\n"
						"Vertex   -00010.000000,+00000.000000,+00000.000000\n"
						"Vertex   +00010.000000,+00040.000000,+00020.000000\nEnd Polygon\nEnd PolyList\nEnd Brush\n"))
			.at(0)
			.Box);
}

TEST(VolumesText, OtherBrushesAreLeftOutAndReported)
{
	for (const char* Brush :
		{"Begin Object Class=/Script/UnrealEd.CylinderBuilder Name=\"CylinderBuilder_0\"\nEnd Object\n",
			"Begin Brush Name=Model_0\nVertex 0,0,0\nVertex 10,10,10\nVertex 5,0,0\nEnd Brush\n"})
	{
		const FRead Result = Read(Actor(std::string(Brush) + "bUnbound=True\n"));
		ASSERT_EQ(1u, Result.Diagnostics.size());
		EXPECT_EQ(
			"clip.txt:1:1: warning DD3025 at A.Brush: the volume's brush is not a box around its pivot; it is left out",
			Result.Diagnostics[0].ToString());
		EXPECT_FALSE(Result.Volumes.at(0).Box);
	}
}

TEST(VolumesText, BoundedVolumeWithoutAShapeIsReported)
{
	const FRead Result = Read(Actor(""));
	ASSERT_EQ(1u, Result.Diagnostics.size());
	EXPECT_EQ(3025, Result.Diagnostics[0].Code);
	EXPECT_FALSE(Result.Volumes.at(0).bUnbound);
}

TEST(VolumesText, BlendWeightIsClampedWithAWarning)
{
	const FRead Result = Read("Settings=()\nBlendWeight=1.5\n");
	ASSERT_EQ(1u, Result.Diagnostics.size());
	EXPECT_EQ("clip.txt:2:13: warning DD3027 at BlendWeight: BlendWeight is clamped to 0..1",
		Result.Diagnostics[0].ToString());
	EXPECT_EQ(1.0, Result.Volumes.at(0).BlendWeight);
}

TEST(VolumesText, BareStructIsAnUnboundVolume)
{
	const FVolumeText Volume = ReadClean(" (bOverride_FilmToe=True,FilmToe=0.4)").at(0);
	EXPECT_TRUE(Volume.bUnbound);
	EXPECT_EQ("", Volume.Name);
	EXPECT_EQ(0.4f, Volume.Settings.Settings.FilmToe);
}

TEST(VolumesText, BareLinesAreAnUnboundVolume)
{
	const FVolumeText Volume = ReadClean("Settings=(bOverride_FilmToe=True,FilmToe=0.4)\r\nPriority=3\r\n").at(0);
	EXPECT_TRUE(Volume.bUnbound);
	EXPECT_EQ(3.0, Volume.Priority);
}

TEST(VolumesText, PostProcessComponentsAreVolumes)
{
	const std::vector<FVolumeText> Volumes =
		ReadClean("Begin Actor Class=/Game/BP_Look.BP_Look_C Name=BP_Look_2\n"
				  "Begin Object Name=\"PostProcess\"\nSettings=(bOverride_FilmToe=True,FilmToe=0.4)\nbUnbound=True\n"
				  "End Object\nEnd Actor\n");
	ASSERT_EQ(1u, Volumes.size());
	EXPECT_EQ("PostProcess", Volumes[0].Name);
}

TEST(VolumesText, SettingsOfOtherClassesAreNotPostProcess)
{
	const FRead Result = Read("Begin Actor Class=/Script/Foliage.Grass Name=A\nSettings=(Density=1)\nEnd Actor\n");
	EXPECT_TRUE(Result.Volumes.empty());
	ASSERT_EQ(1u, Result.Diagnostics.size());
	EXPECT_EQ(3009, Result.Diagnostics[0].Code);
}

TEST(VolumesText, MessagesNameTheActor)
{
	const FRead Result = Read("Begin Actor Name=A\nSettings=(FilmToe=x)\nbUnbound=True\nEnd Actor\n");
	ASSERT_EQ(1u, Result.Diagnostics.size());
	EXPECT_EQ("clip.txt:2:19: error DD3004 at A.FilmToe: expected a number, found x", Result.Diagnostics[0].ToString());
}

TEST(VolumesText, WritesActorsToPaste)
{
	FVolumeText Volume;
	Volume.Name = "Stage";
	Volume.bUnbound = true;
	Volume.Priority = 1.5;
	Volume.Settings.Settings.bOverride_BloomIntensity = true;
	Volume.Settings.Settings.BloomIntensity = 1.2f;
	std::vector<FDiagnostic> Diagnostics;
	EXPECT_EQ("Begin Map\n"
			  "   Begin Level\n"
			  "      Begin Actor Class=/Script/Engine.PostProcessVolume Name=PostProcessVolume_0\n"
			  "         Settings=(bOverride_BloomIntensity=True,BloomIntensity=1.200000)\n"
			  "         Priority=1.500000\n"
			  "         bUnbound=True\n"
			  "         ActorLabel=\"Stage\"\n"
			  "      End Actor\n"
			  "   End Level\n"
			  "End Map\n",
		WriteVolumesText({Volume}, ESettingsTextForm::Delta, Diagnostics));
}

TEST(VolumesText, WhatIsWrittenReadsBack)
{
	std::vector<FVolumeText> Volumes = ReadClean(GMap);
	Volumes[0].Name = "Stage";
	for (const ESettingsTextForm Form : {ESettingsTextForm::Delta, ESettingsTextForm::Full})
	{
		std::vector<FDiagnostic> Diagnostics;
		const std::string Text = WriteVolumesText(Volumes, Form, Diagnostics);
		const std::vector<FVolumeText> Again = ReadClean(Text);
		ASSERT_EQ(2u, Again.size());
		EXPECT_EQ(Volumes[0].Name, Again[0].Name);
		EXPECT_EQ(Volumes[0].Box, Again[0].Box);
		EXPECT_EQ(Volumes[0].BlendWeight, Again[0].BlendWeight);
		EXPECT_EQ(Volumes[1].bEnabled, Again[1].bEnabled);
		EXPECT_EQ(Text, WriteVolumesText(Again, Form, Diagnostics));
	}
}

TEST(VolumesText, LabelsCannotBreakTheText)
{
	FVolumeText Volume;
	Volume.Name = "a\"\nEnd Actor\\";
	Volume.bUnbound = true;
	std::vector<FDiagnostic> Diagnostics;
	const std::vector<FVolumeText> Again = ReadClean(WriteVolumesText({Volume}, ESettingsTextForm::Delta, Diagnostics));
	ASSERT_EQ(1u, Again.size());
	EXPECT_EQ("a__End Actor_", Again[0].Name);
}
