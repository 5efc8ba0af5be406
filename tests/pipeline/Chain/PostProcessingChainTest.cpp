// The chain's insertion points: who is called when, with what, and what becomes of the result.
#include <gtest/gtest.h>

#include "ExtensionTestUtils.h"
#include "Extensions/ExtensionErrors.h"
#include "HAL/ConsoleVariableTools.h"

using namespace ExtensionTest;
using testing::Test;

namespace
{

const FLinearColor Red(1.0f, 0.0f, 0.0f, 1.0f);

FScreenPassTexture FillRed(const FCall& Call)
{
	return Call.Fill(Red);
}

std::vector<double> GetPixel(const FImage& Image, int X, int Y)
{
	return {Image.Get(X, Y, 0), Image.Get(X, Y, 1), Image.Get(X, Y, 2)};
}

const std::vector<double> RedPixel = {1.0, 0.0, 0.0};

} // namespace

// What each point sees ------------------------------------------------------------------------------------------------

struct FSeen
{
	EPoint Point;
	const char* Space;
	EPixelFormat Format;
};

class InsertionPoint : public testing::TestWithParam<FSeen>
{
};

TEST_P(InsertionPoint, SeesItsColourSpaceFormatAndSize)
{
	FIntRect Seen;
	EPixelFormat Format = PF_Unknown;
	const auto Extension = MakeExtension(GetParam().Point,
		[&](const FCall& Call)
		{
			Seen = Call.GetPicture().ViewRect;
			Format = Call.GetPicture().Texture->Desc.Format;
			return Call.GetPicture();
		});
	const FFrameResult Frame = Render(MakeFrame(FIntRect(2, 3, 20, 11)));
	EXPECT_EQ(FIntRect(2, 3, 20, 11), Seen);
	EXPECT_EQ(GetParam().Format, Format);
	const FHookPoint* Point = FindPoint(Frame, GetPassName(GetParam().Point));
	ASSERT_NE(nullptr, Point);
	EXPECT_EQ(GetParam().Space, Point->Space);
	EXPECT_EQ(18, Point->Width);
	EXPECT_EQ(8, Point->Height);
	EXPECT_TRUE(Point->bCalled);
}

INSTANTIATE_TEST_SUITE_P(All, InsertionPoint,
	testing::Values(FSeen{EPoint::SSRInput, "linear HDR, pre-exposed", PF_FloatRGBA},
		FSeen{EPoint::MotionBlur, "linear HDR, pre-exposed", PF_FloatRGBA},
		FSeen{EPoint::Tonemap, "display-encoded", PF_B8G8R8A8}, FSeen{EPoint::FXAA, "display-encoded", PF_B8G8R8A8},
		FSeen{EPoint::VisualizeDepthOfField, "display-encoded", PF_B8G8R8A8}),
	[](const auto& Info) { return GetPassName(Info.param.Point); });

TEST(PostProcessingChain, HdrPointsSeeTheScenesValuesTimesPreExposure)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].PreExposure = 0.5f;
	TRefCountPtr<IPooledRenderTarget> Kept;
	float Seen = 0.0f;
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[&](const FCall& Call)
		{
			Seen = static_cast<const FViewInfo&>(Call.View).PreExposure;
			return Call.GetPicture();
		});
	Render(Inputs);
	EXPECT_EQ(0.5f, Seen);
}

TEST(PostProcessingChain, ThePointsComeInTheEnginesOrder)
{
	const FFrameResult Frame = Render();
	std::vector<std::string> Names;
	for (const FHookPoint& Point : Frame.Log.Points)
	{
		Names.push_back(Point.Point);
	}
	EXPECT_EQ((std::vector<std::string>{"SSRInput", "MotionBlur", "Tonemap", "FXAA", "VisualizeDepthOfField"}), Names);
}

namespace
{

/** With separate translucency of that colour all over. */
FFrameInputs MakeFrameWithTranslucency(const FLinearColor& Color, int32 EngineMinor)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.Engine = *FindEngineProfile(EngineMinor);
	Inputs.RegisterSceneTextures = [Register = Inputs.RegisterSceneTextures, Color](FRDGBuilder& GraphBuilder)
	{
		FSceneTextures SceneTextures = Register(GraphBuilder);
		const TRefCountPtr<FRHITexture> Texture = new FRHITexture(
			FRHITextureDesc::Create2D(SceneTextures.Config.Extent, PF_FloatRGBA, FClearValueBinding::Black,
				ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable),
			TEXT("SeparateTranslucency"));
		for (int32 Index = 0; Index < SceneTextures.Config.Extent.X * SceneTextures.Config.Extent.Y; ++Index)
		{
			Texture->WriteTexelDouble(Index % SceneTextures.Config.Extent.X, Index / SceneTextures.Config.Extent.X,
				FVector4(static_cast<double>(Color.R), static_cast<double>(Color.G), static_cast<double>(Color.B),
					static_cast<double>(Color.A)));
		}
		SceneTextures.SeparateTranslucency = GraphBuilder.RegisterExternalTexture(
			CreateRenderTarget(Texture, TEXT("SeparateTranslucency")), TEXT("SeparateTranslucency"));
		return SceneTextures;
	};
	return Inputs;
}

} // namespace

TEST(PostProcessingChain, ExtensionsSeeSeparateTranslucency)
{
	std::string WithName, WithoutName;
	{
		const auto Extension = MakeExtension(EPoint::MotionBlur,
			[&](const FCall& Call)
			{
				const FScreenPassTexture Slot = Call.Inputs.GetInput(EPostProcessMaterialInput::SeparateTranslucency);
				WithName = Slot.Texture->Name;
				return Call.GetPicture();
			});
		Render(MakeFrameWithTranslucency(FLinearColor(0.25f, 0.25f, 0.25f, 0.5f), 4));
	}
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[&](const FCall& Call)
		{
			const FScreenPassTexture Slot = Call.Inputs.GetInput(EPostProcessMaterialInput::SeparateTranslucency);
			WithoutName = Slot.Texture->Name;
			return Call.GetPicture();
		});
	Render();
	EXPECT_EQ("SeparateTranslucency", WithName);
	EXPECT_NE("SeparateTranslucency", WithoutName);
}

TEST(PostProcessingChain, WhatIsMadeOfTranslucencyIsComposed)
{
	// Opaque red in its place: the picture is that.
	const auto Extension = MakeExtension(EPoint::TranslucencyAfterDOF,
		[](const FCall& Call)
		{
			EXPECT_STREQ("SeparateTranslucency", Call.GetPicture().Texture->Name);
			return Call.Fill(FLinearColor(1.0f, 0.0f, 0.0f, 0.0f));
		});
	FExtensionInfo Info = *GEngine->ViewExtensions->FindInfo(*Extension);
	Info.EngineMinor = AnyEngineVersion;
	GEngine->ViewExtensions->SetInfo(*Extension, Info);
	const FFrameResult Frame = Render(MakeFrameWithTranslucency(FLinearColor(0.25f, 0.25f, 0.25f, 0.5f), 5));
	EXPECT_EQ(RedPixel, GetPixel(Frame.SceneLinear.ToImage(), 5, 5));
	const FHookPoint* Point = FindPoint(Frame, "TranslucencyAfterDOF");
	ASSERT_NE(nullptr, Point);
	EXPECT_TRUE(Point->bCalled);
}

// What becomes of the result
// --------------------------------------------------------------------------------------------

TEST(PostProcessingChain, MotionBlurResultIsThePictureFromThenOn)
{
	const auto Extension = MakeExtension(EPoint::MotionBlur, FillRed);
	const FFrameResult Frame = Render();
	EXPECT_EQ(RedPixel, GetPixel(Frame.SceneLinear.ToImage(), 5, 5));
	EXPECT_GT(Frame.Final.Get(5, 5, 0), Frame.Final.Get(5, 5, 1));
}

TEST(PostProcessingChain, TonemapResultIsTheOutput)
{
	const auto Extension = MakeExtension(EPoint::Tonemap, FillRed);
	EXPECT_EQ(RedPixel, GetPixel(Render().Final.ToImage(), 5, 5));
}

TEST(PostProcessingChain, UntouchedReturnCostsNothing)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.bExecute = false;
	const size_t NumPlain = Render(Inputs).Graph.Passes.size();
	const auto Extension = MakeExtension(EPoint::MotionBlur, [](const FCall& Call) { return Call.Untouched(); });
	EXPECT_EQ(NumPlain, Render(Inputs).Graph.Passes.size());
}

TEST(PostProcessingChain, SSRInputIsKeptAndNotSeen)
{
	const FImage Plain = Render().Final.ToImage();
	const auto Extension = MakeExtension(EPoint::SSRInput, FillRed);
	const FFrameResult Frame = Render();
	EXPECT_EQ(Plain.Values, Frame.Final.ToImage().Values);
	// Extraction keeps the pass alive though this frame does not look at it.
	EXPECT_EQ(std::string::npos, GetDid(Frame, "SSRInput").find("culled")) << GetDid(Frame, "SSRInput");
}

TEST(PostProcessingChain, SubscribersFollowEachOther)
{
	std::string Order;
	const auto First = MakeExtension(EPoint::MotionBlur,
		[&](const FCall& Call)
		{
			Order += "1" + std::string(Call.GetPicture().Texture->Name);
			return Call.Fill(Red);
		});
	const auto Second = MakeExtension(EPoint::MotionBlur,
		[&](const FCall& Call)
		{
			Order += " 2" + std::string(Call.GetPicture().Texture->Name);
			return Call.GetPicture();
		});
	Render();
	EXPECT_EQ("1SceneColor 2Filled", Order);
}

TEST(PostProcessingChain, AnotherSizeWithItsOwnRectIsRescaled)
{
	const auto Extension = MakeExtension(
		EPoint::MotionBlur, [](const FCall& Call) { return Call.MakeTexture(FIntPoint(6, 4), PF_FloatRGBA, Red); });
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{NoteCallbackSize}), GetCodes(Frame));
	EXPECT_EQ(6, Frame.SceneLinear.Width);
	EXPECT_EQ(Width, Frame.Final.Width);
	EXPECT_GT(Frame.Final.Get(Width - 1, Height - 1, 0), 0.5);
}

// Who writes the output
// ---------------------------------------------------------------------------------------------------

TEST(OverrideOutput, GoesToTheTonemapperWhereNobodySubscribed)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.bExecute = false;
	const FFrameResult Frame = Render(Inputs);
	const auto& Passes = Frame.Graph.Passes;
	EXPECT_EQ(4u, Passes.size()); // between the sentinels, the combined table and the tonemapper
}

TEST(OverrideOutput, GoesToTheLastSubscriberOfTheLastPassOnly)
{
	std::string Seen;
	const auto Note = [&](const char* Name)
	{
		return [&Seen, Name](const FCall& Call)
		{
			Seen += std::string(Name) + (Call.Inputs.OverrideOutput.IsValid() ? "+ " : "- ");
			return Call.Fill(Red);
		};
	};
	const auto A = MakeExtension(EPoint::MotionBlur, Note("MotionBlur"));
	const auto B = MakeExtension(EPoint::Tonemap, Note("First"));
	const auto C = MakeExtension(EPoint::Tonemap, Note("Second"));
	const auto D = MakeExtension(EPoint::FXAA, Note("FXAA"));
	Render();
	EXPECT_EQ("MotionBlur- First- Second+ FXAA- ", Seen);
}

TEST(OverrideOutput, IsTheViewFamilysTextureAtTheViewsRect)
{
	std::string Name;
	FIntRect Rect;
	const auto Extension = MakeExtension(EPoint::Tonemap,
		[&](const FCall& Call)
		{
			Name = Call.Inputs.OverrideOutput.Texture->Name;
			Rect = Call.Inputs.OverrideOutput.ViewRect;
			return Call.Fill(Red);
		});
	Render(MakeFrame(FIntRect(2, 3, 20, 11)));
	EXPECT_EQ("ViewFamilyTexture", Name);
	EXPECT_EQ(FIntRect(2, 3, 20, 11), Rect);
}

// A disabled pass
// ---------------------------------------------------------------------------------------------------------

TEST(DisabledPass, CallsItsSubscribersAndDropsWhatTheyReturn)
{
	const FImage Plain = Render().Final.ToImage();
	const auto Extension = MakeExtension(EPoint::FXAA, FillRed);
	const FFrameResult Frame = Render();
	EXPECT_EQ(1, Extension->NumCalls);
	EXPECT_FALSE(Extension->bWasEnabled);
	EXPECT_EQ(Plain.Values, Frame.Final.ToImage().Values);
	EXPECT_EQ((std::vector<int>{WarnCallbackDropped}), GetCodes(Frame));
}

TEST(DisabledPass, MotionBlurIsHeardAllTheSame)
{
	const auto Extension = MakeExtension(EPoint::MotionBlur, FillRed);
	const FFrameResult Frame = Render();
	EXPECT_FALSE(Extension->bWasEnabled);
	EXPECT_TRUE(Frame.Log.Diagnostics.empty());
	EXPECT_EQ(RedPixel, GetPixel(Frame.SceneLinear.ToImage(), 0, 0));
}

TEST(DisabledPass, TonemapIsEnabledAlways)
{
	const auto Extension = MakeExtension(EPoint::Tonemap, FillRed);
	Render();
	EXPECT_TRUE(Extension->bWasEnabled);
}

TEST(DisabledPass, WithoutPostProcessingOnlyTonemapIsCalled)
{
	const auto MotionBlur = MakeExtension(EPoint::MotionBlur, FillRed);
	const auto Tonemap = MakeExtension(EPoint::Tonemap, FillRed);
	FFrameInputs Inputs = MakeFrame();
	Inputs.ShowFlags.SetPostProcessing(false);
	const FFrameResult Frame = Render(Inputs);
	EXPECT_EQ(0, MotionBlur->NumCalls);
	EXPECT_EQ(1, Tonemap->NumCalls);
	EXPECT_EQ((std::vector<int>{WarnPointNotReached}), GetCodes(Frame));
	EXPECT_EQ("ShowFlag.PostProcessing is off", FindPoint(Frame, "MotionBlur")->Reason);
}

// Callbacks that break their contract
// ---------------------------------------------------------------------------------------

struct FMisdeed
{
	const char* Name;
	int Code;
	EPoint Point;
	FScreenPassTexture (*Callback)(const FCall&);
};

class BrokenContract : public testing::TestWithParam<FMisdeed>
{
};

TEST_P(BrokenContract, IsReportedAndThePictureGoesOnUntouched)
{
	const FImage Plain = Render().Final.ToImage();
	const auto Extension = MakeExtension(GetParam().Point, GetParam().Callback);
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{GetParam().Code}), GetCodes(Frame));
	EXPECT_EQ(ESeverity::Warning, Frame.Log.Diagnostics.at(0).Severity);
	EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].ToString().find("FAtPoint"));
	EXPECT_EQ(Plain.Values, Frame.Final.ToImage().Values);
}

TEST_P(BrokenContract, StopsTheRunWithStrictValidation)
{
	const FScopedConsoleVariable Strict(TEXT("r.RDG.Validation"), TEXT("2"));
	const auto Extension = MakeExtension(GetParam().Point, GetParam().Callback);
	EXPECT_THROW(Render(), FError);
}

FScreenPassTexture ReturnNothing(const FCall&)
{
	return FScreenPassTexture();
}
FScreenPassTexture ReturnEmptyRect(const FCall& Call)
{
	return FScreenPassTexture(Call.GetPicture().Texture, FIntRect(4, 4, 4, 8));
}
FScreenPassTexture ReturnOtherExtent(const FCall& Call)
{
	return FScreenPassTexture(
		Call.MakeTexture(FIntPoint(Width / 2, Height / 2), PF_FloatRGBA, Red).Texture, Call.GetPicture().ViewRect);
}
FScreenPassTexture IgnoreOverride(const FCall& Call)
{
	return Call.MakeTexture(FIntPoint(Width, Height), PF_B8G8R8A8, Red);
}
FScreenPassTexture DrawNothing(const FCall& Call)
{
	return Call.Untouched();
}

INSTANTIATE_TEST_SUITE_P(All, BrokenContract,
	testing::Values(FMisdeed{"NoTexture", ErrorCallbackInvalidTexture, EPoint::MotionBlur, ReturnNothing},
		FMisdeed{"NoTextureAsTheLast", ErrorCallbackInvalidTexture, EPoint::Tonemap, ReturnNothing},
		FMisdeed{"EmptyRect", ErrorCallbackInvalidTexture, EPoint::MotionBlur, ReturnEmptyRect},
		FMisdeed{"RectOutside", ErrorCallbackRect, EPoint::MotionBlur, ReturnOtherExtent},
		FMisdeed{"OverrideIgnored", ErrorCallbackOverride, EPoint::Tonemap, IgnoreOverride},
		FMisdeed{"OverrideNotDrawn", ErrorCallbackNotDrawn, EPoint::Tonemap, DrawNothing}),
	[](const auto& Info) { return Info.param.Name; });

TEST(BrokenContracts, DrawingAndReturningTheInputIsNoneAndRemarked)
{
	const FImage Plain = Render().Final.ToImage();
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[](const FCall& Call)
		{
			Call.MakeTexture(FIntPoint(Width, Height), PF_FloatRGBA, Red);
			return Call.GetPicture();
		});
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{NoteCallbackReturnedInput}), GetCodes(Frame));
	EXPECT_EQ(ESeverity::Note, Frame.Log.Diagnostics.at(0).Severity);
	EXPECT_EQ(Plain.Values, Frame.Final.ToImage().Values);
}

TEST(BrokenContracts, ReturningTheInputAloneIsRemarkedOn)
{
	const auto Extension = MakeExtension(EPoint::MotionBlur, [](const FCall& Call) { return Call.GetPicture(); });
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{NoteCallbackDidNothing}), GetCodes(Frame));
	EXPECT_EQ(ESeverity::Note, Frame.Log.Diagnostics.at(0).Severity);
}

TEST(BrokenContracts, AnotherSizeIsRemarkedOn)
{
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[](const FCall& Call) { return Call.MakeTexture(FIntPoint(Width / 2, Height / 2), PF_FloatRGBA, Red); });
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{NoteCallbackSize}), GetCodes(Frame));
	EXPECT_EQ(ESeverity::Note, Frame.Log.Diagnostics.at(0).Severity);
	const std::string Sizes = "a view of " + std::to_string(Width / 2) + " x " + std::to_string(Height / 2) +
							  ", and its input is " + std::to_string(Width) + " x " + std::to_string(Height);
	EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].Message.find(Sizes)) << Frame.Log.Diagnostics[0].Message;
}

TEST(BrokenContracts, AFormatThatCutsLightIsAWarning)
{
	const auto ReturnBytes = [](const FCall& Call)
	{
		return Call.MakeTexture(FIntPoint(Width, Height), PF_B8G8R8A8, Red);
	};
	{
		const auto Extension = MakeExtension(EPoint::MotionBlur, ReturnBytes);
		const FFrameResult Frame = Render();
		EXPECT_EQ((std::vector<int>{WarnCallbackFormat}), GetCodes(Frame));
		EXPECT_EQ(ESeverity::Warning, Frame.Log.Diagnostics.at(0).Severity);
		EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].Message.find("is linear light of "))
			<< Frame.Log.Diagnostics[0].Message;
	}
	// Behind the tonemapper 8 bits are the rule. A second extension stands behind the first one, which is not the last.
	const auto First = MakeExtension(EPoint::Tonemap, ReturnBytes);
	const auto Last = MakeExtension(EPoint::Tonemap, FillRed);
	EXPECT_EQ(std::vector<int>(), GetCodes(Render()));
}

TEST(BrokenContracts, AnUnboundDelegateIsPassedOver)
{
	class FUnbound : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SubscribeToPostProcessingPass(
			EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
		{
			if (Pass == EPostProcessingPass::Tonemap)
			{
				Callbacks.Add(FAfterPassCallbackDelegate());
			}
		}
	};
	const FImage Plain = Render().Final.ToImage();
	const auto Extension = FSceneViewExtensions::NewExtension<FUnbound>();
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{WarnCallbackUnbound}), GetCodes(Frame));
	EXPECT_EQ(Plain.Values, Frame.Final.ToImage().Values);
}
