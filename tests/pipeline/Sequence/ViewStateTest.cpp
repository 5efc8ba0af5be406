// What lives on from frame to frame: who sees it, and that it survives as bytes.
#include <gtest/gtest.h>

#include "ExtensionTestUtils.h"
#include "SceneFile/SceneCamera.h"
#include "Sequence/ViewStateFile.h"
#include "Text/Fingerprint.h"
#include "fuzz/FuzzViewStateChecks.h"

#include <set>

using namespace ExtensionTest;

namespace
{

const FLinearColor Red(1.0f, 0.0f, 0.0f, 1.0f);

FFrameResult RenderAfter(const FFrameResult& Before)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.ViewStates = Before.ViewStates;
	return Render(Inputs);
}

/** Shows what the frame before kept, where it kept something. */
FScreenPassTexture ShowLast(const FCall& Call)
{
	const FSceneViewState& State = *static_cast<const FViewInfo&>(Call.View).ViewState;
	const FScreenPassTexture Last = State.RegisterLastTexture(Call.GraphBuilder, CustomSSRInputName);
	return Last.IsValid() ? Last : Call.Untouched();
}

/** A history with a texture, of which (1, 0) to (3, 2) count, and a buffer. */
std::vector<FViewHistory> MakeHistory(float Inside = 0.25f, float Beside = 0.5f)
{
	const TRefCountPtr<FRHITexture> Texture =
		new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(5, 2), PF_FloatRGBA, FClearValueBinding::White,
							ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable),
			TEXT("Texture"));
	Texture->Fill(FLinearColor(Beside, Beside, Beside, Beside));
	Texture->WriteTexel(2, 1, FLinearColor(Inside, -2.0f, 65504.0f, 0.0f));
	const TRefCountPtr<FRDGPooledBuffer> Buffer =
		GRenderGraphResourcePool.FindFreeBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 3), TEXT("Buffer"));
	const uint32 Numbers[] = {1, 0x7FC00001u, 3};
	std::copy_n(reinterpret_cast<const uint8*>(Numbers), sizeof(Numbers), Buffer->GetRHI()->GetData());

	FViewHistory View;
	View.bValid = true;
	View.FrameNumber = 41;
	View.Projection.emplace();
	View.Projection->ViewOrigin = FVector(0.1, -2.0, 3e30);
	View.Projection->ProjectionMatrix.M[2][3] = 0.3;
	View.Projection->SetViewRectangle(FIntRect(1, 0, 3, 2));
	View.Textures["Kept"] = {CreateRenderTarget(Texture, TEXT("Texture")), FIntRect(1, 0, 3, 2)};
	View.Buffers["Numbers"] = Buffer;
	return {View, FViewHistory()};
}

std::string ErrorOf(const std::string& Bytes)
{
	try
	{
		UnpackViewStates(Bytes, "a.bin");
	}
	catch (const FError& Error)
	{
		return std::to_string(Error.GetDiagnostics().at(0).Code) + " " + Error.GetDiagnostics().at(0).Message;
	}
	return "none";
}

template<typename T>
std::string BytesOf(const std::vector<T>& Numbers)
{
	return std::string(reinterpret_cast<const char*>(Numbers.data()), Numbers.size() * sizeof(T));
}

/** A state in which the last numbers From are others, with the fingerprint that goes with it. */
template<typename T>
std::string Forge(const std::string& State, const std::vector<T>& From, const std::vector<T>& To)
{
	std::string Forged = State;
	const size_t At = Forged.rfind(BytesOf(From));
	EXPECT_NE(std::string::npos, At);
	Forged.replace(At, BytesOf(From).size(), BytesOf(To));
	return SealViewState(Forged);
}

} // namespace

TEST(ViewState, SSRInputIsSeenByTheNextFrame)
{
	const auto Keep = MakeExtension(EPoint::SSRInput, [](const FCall& Call) { return Call.Fill(Red); });
	const auto Show = MakeExtension(EPoint::MotionBlur, ShowLast);
	const FFrameResult First = Render();
	EXPECT_EQ(0.25, First.SceneLinear.Get(3, 3, 2)); // its own blue
	EXPECT_EQ(0.0, RenderAfter(First).SceneLinear.Get(3, 3, 2));
	EXPECT_EQ(1.0, RenderAfter(First).SceneLinear.Get(3, 3, 0));
}

TEST(ViewState, SameHistoryGivesTheSameFrame)
{
	const auto Keep = MakeExtension(EPoint::SSRInput, [](const FCall& Call) { return Call.Fill(Red); });
	const FFrameResult First = Render();
	EXPECT_EQ(RenderAfter(First).Final.ToImage().Values, RenderAfter(First).Final.ToImage().Values);
	EXPECT_EQ(
		FingerprintViewStates(RenderAfter(First).ViewStates), FingerprintViewStates(RenderAfter(First).ViewStates));
}

TEST(ViewState, WhatAFrameDoesNotKeepIsForgotten)
{
	FFrameResult First;
	{
		const auto Keep = MakeExtension(EPoint::SSRInput, [](const FCall& Call) { return Call.Fill(Red); });
		First = Render();
	}
	EXPECT_EQ(1u, First.ViewStates.at(0).Textures.count(CustomSSRInputName));
	EXPECT_EQ(0u, RenderAfter(First).ViewStates.at(0).Textures.size());
}

TEST(ViewState, FirstFrameIsACut)
{
	std::vector<bool> Cuts;
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[&](const FCall& Call)
		{
			Cuts.push_back(Call.View.bCameraCut);
			return Call.Untouched();
		});
	RenderAfter(Render());
	EXPECT_EQ((std::vector<bool>{true, false}), Cuts);
}

TEST(ViewState, BuffersAreKeptBySameName)
{
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[](const FCall& Call)
		{
			FSceneViewState& State = *static_cast<const FViewInfo&>(Call.View).ViewState;
			const FRDGBufferRef Last = State.RegisterLastBuffer(Call.GraphBuilder, TEXT("Count"));
			const uint32 One = 1;
			FRDGBufferRef Next = Last;
			if (Next == nullptr)
			{
				Next = Call.GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 1), TEXT("Count"));
				Call.GraphBuilder.QueueBufferUpload(Next, &One, sizeof(One));
			}
			State.KeepBuffer(Call.GraphBuilder, TEXT("Count"), Next);
			return Call.Untouched();
		});
	const FFrameResult Second = RenderAfter(Render());
	ASSERT_EQ(1u, Second.ViewStates.at(0).Buffers.count("Count"));
	EXPECT_EQ(1, *Second.ViewStates[0].Buffers.at("Count")->GetRHI()->GetData());
}

TEST(ViewState, ClipSpaceOfTheFrameBefore)
{
	// A camera at the origin looks along X, one 100 cm ahead of it, turned by 90 degrees, along Y.
	FSceneCamera Camera;
	const FIntRect Rect(0, 0, 320, 180);
	const FSceneViewProjectionData Before = MakeProjectionData(Camera, Rect.Size(), Rect, Rect);
	Camera.Location = FVector(100.0, 0.0, 0.0);
	Camera.Yaw = 90.0;
	const FSceneViewProjectionData Now = MakeProjectionData(Camera, Rect.Size(), Rect, Rect);
	EXPECT_EQ(FMatrix44f::Identity, MakeClipToPrevClip(Now, Now));

	// (400, 200, 50) is, relative to now's camera, 300 to the left of its axis and 200 ahead; of before's 200 to the
	// right and 400 ahead. With 90 degrees of view both sides are one half: x / depth, and 16/9 of height / depth.
	const float Clip[] = {-300.0f, 50.0f * 16.0f / 9.0f, static_cast<float>(SceneNearPlane), 200.0f};
	const float Expected[] = {200.0f, 50.0f * 16.0f / 9.0f, static_cast<float>(SceneNearPlane), 400.0f};
	const FMatrix44f Matrix = MakeClipToPrevClip(Now, Before);
	for (int32 Column = 0; Column < 4; ++Column)
	{
		float Sum = 0.0f;
		for (int32 Row = 0; Row < 4; ++Row)
		{
			Sum += Clip[Row] * Matrix.M[Row][Column];
		}
		EXPECT_NEAR(Expected[Column], Sum, 1e-3f) << Column;
	}
}

TEST(ViewStateFile, BytesGiveTheSameHistory)
{
	const std::string Bytes = PackViewStates(MakeHistory());
	const std::vector<FViewHistory> Back = UnpackViewStates(Bytes, "a.bin");
	EXPECT_EQ(Bytes, PackViewStates(Back));
	ASSERT_EQ(2u, Back.size());
	EXPECT_FALSE(Back[1].bValid);
	EXPECT_EQ(41u, Back[0].FrameNumber);
	EXPECT_EQ(FVector(0.1, -2.0, 3e30), Back[0].Projection->ViewOrigin);
	FRHITexture& Texture = *Back[0].Textures.at("Kept").Target->GetRHI();
	EXPECT_EQ(FLinearColor(0.25f, -2.0f, 65504.0f, 0.0f), Texture.ReadTexel(2, 1));
	EXPECT_EQ(FLinearColor(0.5f, 0.5f, 0.5f, 0.5f), Texture.ReadTexel(4, 0));
}

TEST(ViewStateFile, EveryCutAndEveryChangeIsFound)
{
	const std::string Bytes = PackViewStates(MakeHistory());
	for (size_t Size = 0; Size < Bytes.size(); ++Size)
	{
		EXPECT_EQ("5020", ErrorOf(Bytes.substr(0, Size)).substr(0, 4)) << Size;
	}
	for (size_t At = 0; At < Bytes.size(); ++At)
	{
		std::string Changed = Bytes;
		Changed[At] = static_cast<char>(Changed[At] ^ 16);
		EXPECT_EQ("5020", ErrorOf(Changed).substr(0, 4)) << At;
	}
}

TEST(ViewStateFile, FingerprintSeesTheViewRectOnly)
{
	const std::string Plain = FingerprintViewStates(MakeHistory());
	EXPECT_EQ(Plain, FingerprintViewStates(MakeHistory(0.25f, 0.5f)));
	EXPECT_NE(Plain, FingerprintViewStates(MakeHistory(0.75f)));
	std::vector<FViewHistory> Beside = MakeHistory();
	Beside[0].Textures["Kept"].Target->GetRHI()->WriteTexel(4, 1, Red);
	EXPECT_EQ(Plain, FingerprintViewStates(Beside));
}

TEST(ViewStateFile, ForgedSizesAreRefusedBeforeMemoryIsTaken)
{
	const std::string State = PackViewStates(MakeHistory());
	const std::string Broken = "5020 the state of a frame ";
	EXPECT_EQ("none", ErrorOf(Forge<uint32>(State, {4, 3}, {4, 3})));
	EXPECT_EQ(Broken + "has an impossible buffer", ErrorOf(Forge<uint32>(State, {4, 3}, {4, 0})));
	EXPECT_EQ(Broken + "has an impossible buffer", ErrorOf(Forge<uint32>(State, {4, 3}, {65536, 65536})));
	EXPECT_EQ(Broken + "is cut short", ErrorOf(Forge<uint32>(State, {4, 3}, {1u << 30, 3})));
	EXPECT_EQ(Broken + "has an impossible texture", ErrorOf(Forge<int32>(State, {1, 0, 3, 2}, {1, 0, 30, 2})));
	EXPECT_EQ(Broken + "has an impossible texture", ErrorOf(Forge<int32>(State, {1, 0, 3, 2}, {-1, 0, 3, 2})));

	FRHITextureDesc Desc = MakeHistory()[0].Textures["Kept"].Target->GetRHI()->GetDesc();
	const uint64 Size = FRHITexture::ComputeSize(Desc);
	Desc.Extent = FIntPoint(16384, 16384);
	const std::string Large = Forge<int32>(State, {5, 2}, {16384, 16384});
	EXPECT_EQ(Broken + "is cut short", ErrorOf(Forge<uint64>(Large, {Size}, {FRHITexture::ComputeSize(Desc)})));
}

TEST(Fingerprint, CutsDoNotMatter)
{
	const std::string Text = "the quick brown fox jumps over the lazy dog, and over the fence as well";
	FFingerprint Whole;
	Whole.Add(Text.data(), Text.size());
	for (size_t Cut = 0; Cut <= Text.size(); ++Cut)
	{
		FFingerprint Parts;
		Parts.Add(Text.data(), Cut);
		Parts.Add(Text.data() + Cut, Text.size() - Cut);
		EXPECT_EQ(Whole.Get(), Parts.Get()) << Cut;
	}
}

TEST(Fingerprint, EveryBitAndTheLengthMatter)
{
	std::set<std::string> Seen;
	std::string Text(70, '\0');
	for (size_t Bit = 0; Bit < Text.size() * 8; ++Bit)
	{
		Text[Bit / 8] = static_cast<char>(1u << (Bit % 8));
		FFingerprint Fingerprint;
		Fingerprint.Add(Text.data(), Text.size());
		Seen.insert(Fingerprint.Get());
		Text[Bit / 8] = '\0';
	}
	for (size_t Length = 0; Length <= Text.size(); ++Length)
	{
		FFingerprint Fingerprint;
		Fingerprint.Add(Text.data(), Length);
		Seen.insert(Fingerprint.Get());
	}
	EXPECT_EQ(70u * 8u + 71u, Seen.size());
}
