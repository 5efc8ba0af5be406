// What helpers refuse where they are called: null, garbage and left-over pointers, copies that do not fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rdg/graph/Graph/GraphTestBuilder.h"
#include "RHIGPUReadback.h"
#include "RenderGraphUtils.h"
#include "ScreenPass.h"

#include <cstring>
#include <functional>
#include <random>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

/** The one message that Call throws; number 0: none. */
FDiagnostic GetMessage(const std::function<void()>& Call)
{
	try
	{
		Call();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_EQ(1u, Error.GetDiagnostics().size());
		return Error.GetDiagnostics()[0];
	}
	return {};
}

/** Bytes that nobody may look into. */
template<typename T>
T* MakeGarbage()
{
	alignas(16) static char Garbage[1024];
	std::memset(Garbage, 0x5a, sizeof(Garbage));
	return reinterpret_cast<T*>(Garbage);
}

/** Every helper with one texture, view or buffer, by the name of its parameter. */
struct FHelper
{
	const char* Place;
	std::function<void(FGraphTest&, void*)> Call;
};

const FHelper GHelpers[] = {
	{"AddCopyTexturePass, parameter InputTexture",
		[](FGraphTest& Graph, void* Object)
		{
			AddCopyTexturePass(*Graph.Builder, static_cast<FRDGTextureRef>(Object), Graph.Texture("X"));
		}},
	{"AddCopyTexturePass, parameter OutputTexture",
		[](FGraphTest& Graph, void* Object)
		{
			AddCopyTexturePass(*Graph.Builder, Graph.Texture("X"), static_cast<FRDGTextureRef>(Object));
		}},
	{"AddDrawTexturePass, parameter InputTexture",
		[](FGraphTest& Graph, void* Object)
		{
			AddDrawTexturePass(
				*Graph.Builder, FScreenPassViewInfo(), static_cast<FRDGTextureRef>(Object), Graph.Texture("X"));
		}},
	{"AddClearRenderTargetPass, parameter Texture",
		[](FGraphTest& Graph, void* Object)
		{
			AddClearRenderTargetPass(*Graph.Builder, static_cast<FRDGTextureRef>(Object));
		}},
	{"AddClearRenderTargetPass, parameter Texture",
		[](FGraphTest& Graph, void* Object)
		{
			AddClearRenderTargetPass(*Graph.Builder, static_cast<FRDGTextureRef>(Object), FLinearColor::Red);
		}},
	{"AddClearDepthStencilPass, parameter Texture",
		[](FGraphTest& Graph, void* Object)
		{
			AddClearDepthStencilPass(*Graph.Builder, static_cast<FRDGTextureRef>(Object));
		}},
	{"AddClearUAVPass, parameter UAV",
		[](FGraphTest& Graph, void* Object)
		{
			AddClearUAVPass(*Graph.Builder, static_cast<FRDGTextureUAVRef>(Object), FLinearColor::Red);
		}},
	{"AddClearUAVPass, parameter UAV",
		[](FGraphTest& Graph, void* Object)
		{
			AddClearUAVPass(*Graph.Builder, static_cast<FRDGBufferUAVRef>(Object), 7u);
		}},
	{"AddCopyBufferPass, parameter SrcBuffer",
		[](FGraphTest& Graph, void* Object)
		{
			AddCopyBufferPass(*Graph.Builder, static_cast<FRDGBufferRef>(Object), static_cast<FRDGBufferRef>(Object));
		}},
	{"AddEnqueueCopyPass, parameter SourceTexture",
		[](FGraphTest& Graph, void* Object)
		{
			FRHIGPUTextureReadback Readback(TEXT("Readback"));
			AddEnqueueCopyPass(*Graph.Builder, &Readback, static_cast<FRDGTextureRef>(Object));
		}},
	{"FScreenPassRenderTarget::CreateFromInput, parameter Input",
		[](FGraphTest& Graph, void* Object)
		{
			FScreenPassTexture Input;
			Input.Texture = static_cast<FRDGTextureRef>(Object);
			FScreenPassRenderTarget::CreateFromInput(
				*Graph.Builder, Input, ERenderTargetLoadAction::ENoAction, TEXT("Output"));
		}},
	{"AddPassDependency, parameter Producer",
		[](FGraphTest& Graph, void* Object)
		{
			Graph.Builder->AddPassDependency(static_cast<FRDGPassRef>(Object), static_cast<FRDGPassRef>(Object));
		}},
	{"SetPassWorkload, parameter Pass",
		[](FGraphTest& Graph, void* Object)
		{
			Graph.Builder->SetPassWorkload(static_cast<FRDGPassRef>(Object), 1);
		}},
};

} // namespace

TEST(Arguments, NullIsNamed)
{
	for (const FHelper& Helper : GHelpers)
	{
		FGraphTest Graph;
		const FDiagnostic Message = GetMessage([&] { Helper.Call(Graph, nullptr); });
		EXPECT_EQ(RDGErrorNullArgument, Message.Code) << Helper.Place;
		EXPECT_EQ(Helper.Place, Message.Where);
	}
}

TEST(Arguments, GarbageIsNotLookedInto)
{
	for (const FHelper& Helper : GHelpers)
	{
		FGraphTest Graph;
		const FDiagnostic Message = GetMessage([&] { Helper.Call(Graph, MakeGarbage<void>()); });
		EXPECT_EQ(RDGErrorForeignResource, Message.Code) << Helper.Place;
		EXPECT_EQ(Helper.Place, Message.Where);
	}
}

TEST(Arguments, AnObjectOfAnotherKindIsNone)
{
	for (const FHelper& Helper : GHelpers)
	{
		FGraphTest Graph;
		// As when a pointer left from another graph finds something else at its address.
		FRDGUniformBuffer* const Other =
			Graph.Builder->CreateUniformBuffer(Graph.Builder->AllocParameters<FScreenPassTextureViewportParameters>());
		EXPECT_EQ(RDGErrorForeignResource, GetMessage([&] { Helper.Call(Graph, Other); }).Code) << Helper.Place;
	}
}

TEST(Arguments, TheLineIsThatOfTheCall)
{
	FGraphTest Graph;
	const int Line = __LINE__ + 1;
	const FDiagnostic Message = GetMessage([&] { AddCopyTexturePass(*Graph.Builder, nullptr, Graph.Texture("X")); });
	EXPECT_EQ(Line, Message.Line);
	EXPECT_THAT(Message.File, HasSubstr("ArgumentsTest.cpp"));
}

TEST(Arguments, ACopyDoesNotConvert)
{
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Format = PF_R8G8B8A8;
	const FDiagnostic Message =
		GetMessage([&] { AddCopyTexturePass(*Graph.Builder, Graph.Texture("X"), Graph.Texture("Y", Desc)); });
	EXPECT_EQ(RDGErrorCopy, Message.Code);
	EXPECT_EQ("a copy does not convert: X is PF_R32_FLOAT, Y is PF_R8G8B8A8; draw it with AddDrawTexturePass",
		Message.Message);
	EXPECT_EQ("pass CopyTexture(X -> Y)", Message.Where);
}

namespace
{

/** One copy between two textures of 8 x 6 texels, 3 mips and 2 slices. */
struct FCopyCase
{
	FRHICopyTextureInfo Info;

	/** Texel by texel: whether all that is read and written is there. */
	bool Fits() const
	{
		bool bFits = Info.NumSlices > 0;
		for (uint32 Mip = 0; Mip < Info.NumMips; ++Mip)
		{
			const bool bWhole = Info.Size == FIntVector(0, 0, 0);
			const int32 X0 = Info.SourcePosition.X >> Mip;
			const int32 Y0 = Info.SourcePosition.Y >> Mip;
			const int32 SizeX = bWhole ? GetSize(8, Info.SourceMipIndex + Mip) - X0 : std::max(1, Info.Size.X >> Mip);
			const int32 SizeY = bWhole ? GetSize(6, Info.SourceMipIndex + Mip) - Y0 : std::max(1, Info.Size.Y >> Mip);
			bFits = bFits && SizeX > 0 && SizeY > 0;
			for (int32 Y = 0; Y < SizeY; ++Y)
			{
				for (int32 X = 0; X < SizeX; ++X)
				{
					for (uint32 Slice = 0; Slice < Info.NumSlices; ++Slice)
					{
						bFits = bFits &&
								IsThere(X0 + X, Y0 + Y, Info.SourceMipIndex + Mip, Info.SourceSliceIndex + Slice) &&
								IsThere((Info.DestPosition.X >> Mip) + X, (Info.DestPosition.Y >> Mip) + Y,
									Info.DestMipIndex + Mip, Info.DestSliceIndex + Slice);
					}
				}
			}
		}
		return bFits;
	}

	static int32 GetSize(int32 Size, uint32 Mip) { return Mip < 3 ? std::max(1, Size >> Mip) : 0; }
	static bool IsThere(int32 X, int32 Y, uint32 Mip, uint32 Slice)
	{
		return Slice < 2 && X >= 0 && Y >= 0 && X < GetSize(8, Mip) && Y < GetSize(6, Mip);
	}
};

} // namespace

TEST(Arguments, ACopyIsRefusedWhereATexelIsNotThere)
{
	std::mt19937 Random(16);
	const auto Draw = [&Random](int32 First, int32 Last)
	{
		return First + int32(Random() % uint32(Last - First + 1));
	};
	int NumRefused = 0;
	for (int Round = 0; Round < 3000; ++Round)
	{
		FGraphTest Graph;
		const FRDGTextureDesc Desc = FRDGTextureDesc::Create2DArray(FIntPoint(8, 6), PF_R32_FLOAT,
			FClearValueBinding::Black, TexCreate_ShaderResource | TexCreate_RenderTargetable, 2, 3);
		FCopyCase Case;
		FRHICopyTextureInfo& Info = Case.Info;
		Info.Size = Draw(0, 1) ? FIntVector(0, 0, 0) : FIntVector(Draw(1, 9), Draw(1, 7), 1);
		Info.SourcePosition = FIntVector(Draw(-1, 4), Draw(-1, 3), 0);
		Info.DestPosition = FIntVector(Draw(-1, 4), Draw(-1, 3), 0);
		Info.SourceMipIndex = uint32(Draw(0, 2));
		Info.DestMipIndex = uint32(Draw(0, 2));
		Info.NumMips = uint32(Draw(1, 2));
		Info.SourceSliceIndex = uint32(Draw(0, 1));
		Info.DestSliceIndex = uint32(Draw(0, 1));
		Info.NumSlices = uint32(Draw(1, 2));
		const FDiagnostic Message = GetMessage(
			[&] { AddCopyTexturePass(*Graph.Builder, Graph.Texture("X", Desc), Graph.Texture("Y", Desc), Info); });
		ASSERT_EQ(Case.Fits() ? 0 : int(RDGErrorCopy), Message.Code) << "round " << Round << ": " << Message.Message;
		NumRefused += Message.Code != 0;
	}
	EXPECT_GT(NumRefused, 500);
	EXPECT_LT(NumRefused, 2990);
}

TEST(Arguments, BytesBeyondABufferAreRefused)
{
	FGraphTest Graph;
	FRDGBufferRef Small = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 4), TEXT("Small"));
	FRDGBufferRef Large = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 8), TEXT("Large"));
	EXPECT_EQ(0, GetMessage([&] { AddCopyBufferPass(*Graph.Builder, Large, 16, Small, 0, 16); }).Code);
	EXPECT_EQ(RDGErrorCopy, GetMessage([&] { AddCopyBufferPass(*Graph.Builder, Large, 17, Small, 0, 16); }).Code);
	EXPECT_EQ(RDGErrorCopy, GetMessage([&] { AddCopyBufferPass(*Graph.Builder, Large, 0, Small, 1, 16); }).Code);
	EXPECT_EQ(RDGErrorCopy, GetMessage([&] { AddCopyBufferPass(*Graph.Builder, Small, Large); }).Code);
	EXPECT_EQ(RDGErrorCopy, GetMessage([&] { AddCopyBufferPass(*Graph.Builder, Large, 0, Small, ~0ull, 2); }).Code);
}

TEST(Arguments, ANullReadbackIsNamed)
{
	FGraphTest Graph;
	const FDiagnostic Message = GetMessage(
		[&] { AddEnqueueCopyPass(*Graph.Builder, static_cast<FRHIGPUTextureReadback*>(nullptr), Graph.Texture("X")); });
	EXPECT_EQ(RDGErrorNullArgument, Message.Code);
	EXPECT_THAT(Message.Where, HasSubstr("Readback"));
}

TEST(Arguments, AReadbackBeyondItsTextureIsNamed)
{
	FGraphTest Graph;
	FRHIGPUTextureReadback Readback(TEXT("Readback"));
	const FRDGTextureRef Texture = Graph.Texture("X");
	const FIntPoint Extent = Texture->Desc.Extent;
	const FResolveRect Beyond[] = {
		{0, 0, Extent.X + 1, 1}, {0, Extent.Y, 1, Extent.Y + 1}, {1, 1, 2147483647, 2147483647}};
	for (const FResolveRect& Rect : Beyond)
	{
		const FDiagnostic Message = GetMessage([&] { AddEnqueueCopyPass(*Graph.Builder, &Readback, Texture, Rect); });
		EXPECT_EQ(RDGErrorCopy, Message.Code);
		EXPECT_THAT(Message.Where, HasSubstr("resource X"));
	}
	const FResolveRect Corner{Extent.X - 1, Extent.Y - 1, Extent.X, Extent.Y};
	EXPECT_EQ(0, GetMessage([&] { AddEnqueueCopyPass(*Graph.Builder, &Readback, Texture, Corner); }).Code);
}

TEST(Arguments, APassWithoutOutputsSaysWhichAreNotSet)
{
	FGraphTest Graph;
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestRasterParameters>();
	Graph.Builder->AddPass(RDG_EVENT_NAME("Idle"), Parameters, ERDGPassFlags::Raster, [](FRHICommandList&) {});
	const FDiagnostic Message = GetMessage([&] { Graph.Run(); });
	EXPECT_EQ(RDGErrorNoOutput, Message.Code);
	EXPECT_THAT(Message.Message, HasSubstr("not set, or unused by its shader: "));
	EXPECT_THAT(Message.Message, HasSubstr("RenderTargets[0]"));
}
