// Passes with a vertex shader of their own: the rectangle and the TEXCOORDs that it gives reach the pixel shader. A
// little past 500 lines: the cases share the shader classes and the pass that draws with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "CommonRenderResources.h"
#include "PixelShaderUtils.h"
#include "RenderGraphNotes.h"
#include "ScreenPass.h"

using namespace Drydock;

/** Without parameters, as most of them. */
class FOwnScreenVS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FOwnScreenVS);

	FOwnScreenVS() = default;
	FOwnScreenVS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}
};

class FOwnTriangleVS : public FOwnScreenVS
{
	DECLARE_GLOBAL_SHADER(FOwnTriangleVS);
};

class FOwnSquareVS : public FOwnScreenVS
{
	DECLARE_GLOBAL_SHADER(FOwnSquareVS);
};

class FOwnMeshVS : public FOwnScreenVS
{
	DECLARE_GLOBAL_SHADER(FOwnMeshVS);
};

BEGIN_SHADER_PARAMETER_STRUCT(FOwnKawaseParameters, )
	SHADER_PARAMETER(FVector2f, TapOffset)
	SHADER_PARAMETER(FVector2f, InvTextureSize)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FOwnKawaseVS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FOwnKawaseVS);
	SHADER_USE_PARAMETER_STRUCT(FOwnKawaseVS, FGlobalShader);
	using FParameters = FOwnKawaseParameters;
};

class FOwnKawasePS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FOwnKawasePS);
	SHADER_USE_PARAMETER_STRUCT(FOwnKawasePS, FGlobalShader);
	using FParameters = FOwnKawaseParameters;
};

class FOwnShowPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FOwnShowPS);
	SHADER_USE_PARAMETER_STRUCT(FOwnShowPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FOwnScreenVS, "/OwnVertexTest/OwnVertex.usf", "ScreenVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FOwnTriangleVS, "/OwnVertexTest/OwnVertex.usf", "TriangleVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FOwnSquareVS, "/OwnVertexTest/OwnVertex.usf", "SquareVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FOwnMeshVS, "/OwnVertexTest/OwnVertex.usf", "MeshVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FOwnKawaseVS, "/OwnVertexTest/OwnVertex.usf", "KawaseVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FOwnKawasePS, "/OwnVertexTest/OwnVertex.usf", "KawasePS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FOwnShowPS, "/OwnVertexTest/OwnVertex.usf", "ShowPS", SF_Pixel);

namespace
{

const FLinearColor GUntouched(-99, -99, -99, -99);

/** How far two ways to the same value may lie apart, where no corner's value is above 1. A corner is a product and two
 * sums of floats, or one quotient: 8 roundings for both. A kernel computes float(DX) * (X + 0.5) + float(Row): of each
 * way four roundings of the product, which may be larger than what comes out, and two of the result. */
double GetBound(double SlopeX, int32 X)
{
	return (8 + 2 * (4 * std::abs(SlopeX) * (X + 0.5) + 2)) / (1 << 24);
}

template<typename TShader>
TShaderMapRef<TShader> Get()
{
	return TShaderMapRef<TShader>(GetGlobalShaderMap(GMaxRHIFeatureLevel));
}

class OwnVertexShader : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/OwnVertexTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/GraphUtils/Shaders"));
	}

	/** A graph of one pass that renders to a texture of this size; what is drawn nowhere stays GUntouched. */
	void Run(FIntPoint Extent, const std::function<void(FRDGBuilder&, FRDGTextureRef)>& AddPass)
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("OwnVertex"));
		const FRDGTextureRef Texture =
			GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Extent, PF_A32B32G32R32F, FClearValueBinding::Black,
										   TexCreate_ShaderResource | TexCreate_RenderTargetable),
				TEXT("Target"));
		AddClearRenderTargetPass(GraphBuilder, Texture, GUntouched);
		AddPass(GraphBuilder, Texture);
		GraphBuilder.QueueTextureExtraction(Texture, &Pooled);
		GraphBuilder.Execute();
		Notes = GetGraphNotes(GraphBuilder);
	}

	FLinearColor GetPixel(int32 X, int32 Y) const { return Pooled->GetRHI()->ReadTexel(X, Y); }

	template<typename TVertexShader>
	static void AddShow(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, const FIntRect& Output,
		const FScreenPassTextureViewport& Input)
	{
		auto* Parameters = GraphBuilder.AllocParameters<FOwnShowPS::FParameters>();
		Parameters->RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::ELoad);
		AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Show"), FScreenPassViewInfo(),
			FScreenPassTextureViewport(Texture, Output), Input, Get<TVertexShader>(), Get<FOwnShowPS>(), Parameters);
	}

	/** A raster pass as plugins write it; Draw(RHICmdList) after states and parameters are set. */
	template<typename TVertexShader>
	static void AddRawShow(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, FRHIVertexDeclaration* Declaration,
		const std::function<void(FRHICommandList&)>& Draw, EPrimitiveType PrimitiveType = PT_TriangleList)
	{
		auto* Parameters = GraphBuilder.AllocParameters<FOwnShowPS::FParameters>();
		Parameters->RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::ELoad);
		GraphBuilder.AddPass(RDG_EVENT_NAME("RawShow"), Parameters, ERDGPassFlags::Raster,
			[Parameters, Declaration, Draw, PrimitiveType](FRHICommandListImmediate& RHICmdList)
			{
				FGraphicsPipelineStateInitializer GraphicsPSOInit;
				RHICmdList.ApplyCachedRenderTargets(GraphicsPSOInit);
				GraphicsPSOInit.BlendState = TStaticBlendState<>::GetRHI();
				GraphicsPSOInit.DepthStencilState = TStaticDepthStencilState<false, CF_Always>::GetRHI();
				GraphicsPSOInit.BoundShaderState.VertexDeclarationRHI = Declaration;
				GraphicsPSOInit.BoundShaderState.VertexShaderRHI = Get<TVertexShader>().GetVertexShader();
				GraphicsPSOInit.BoundShaderState.PixelShaderRHI = Get<FOwnShowPS>().GetPixelShader();
				GraphicsPSOInit.PrimitiveType = PrimitiveType;
				SetGraphicsPipelineState(RHICmdList, GraphicsPSOInit, 0);
				SetShaderParameters(RHICmdList, Get<FOwnShowPS>(), Get<FOwnShowPS>().GetPixelShader(), *Parameters);
				Draw(RHICmdList);
			});
	}

	TRefCountPtr<IPooledRenderTarget> Pooled;
	std::vector<FDiagnostic> Notes;
};

/** Writes a value of its own to every texel. */
FRDGTextureRef AddNoise(FRDGBuilder& GraphBuilder, const std::vector<FLinearColor>& Colors, FIntPoint Size)
{
	const FTextureRHIRef Noise = new FRHITexture(
		FRDGTextureDesc::Create2D(Size, PF_A32B32G32R32F, FClearValueBinding::None, TexCreate_ShaderResource),
		TEXT("Noise"));
	for (int32 i = 0; i < Size.X * Size.Y; ++i)
	{
		Noise->WriteTexel(i % Size.X, i / Size.X, Colors[size_t(i)]);
	}
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Noise, TEXT("Noise")));
}

/** Bilinear, clamped; coordinates in texels. */
FLinearColor SampleBilinear(const std::vector<FLinearColor>& Colors, FIntPoint Size, double X, double Y)
{
	X = std::round(X * 256) / 256 - 0.5;
	Y = std::round(Y * 256) / 256 - 0.5;
	FLinearColor Sum(0, 0, 0, 0);
	for (int32 j = 0; j < 2; ++j)
	{
		for (int32 i = 0; i < 2; ++i)
		{
			const int32 AtX = std::clamp(int32(std::floor(X)) + i, 0, Size.X - 1);
			const int32 AtY = std::clamp(int32(std::floor(Y)) + j, 0, Size.Y - 1);
			const double Part =
				(i ? X - std::floor(X) : 1 - (X - std::floor(X))) * (j ? Y - std::floor(Y) : 1 - (Y - std::floor(Y)));
			Sum += Colors[size_t(AtY * Size.X + AtX)] * float(Part);
		}
	}
	return Sum;
}

} // namespace

TEST_F(OwnVertexShader, GivesThePictureOfTheEnginesWhereItGivesTheSame)
{
	std::mt19937 Random(2130);
	const auto Draw = [&Random](int32 Low, int32 High)
	{
		return std::uniform_int_distribution<int32>(Low, High)(Random);
	};
	for (int32 Round = 0; Round < 30; ++Round)
	{
		const FIntPoint Extent(Draw(1, 150), Draw(1, 90));
		const FIntPoint Min(Draw(0, Extent.X - 1), Draw(0, Extent.Y - 1));
		const FIntRect Output(Min, Min + FIntPoint(Draw(1, Extent.X - Min.X), Draw(1, Extent.Y - Min.Y)));
		const FIntPoint InputMin(Draw(0, 50), Draw(0, 50));
		const FIntRect InputRect(InputMin, InputMin + FIntPoint(Draw(1, 900), Draw(1, 900)));
		const FScreenPassTextureViewport Input(InputRect.Max + FIntPoint(Draw(0, 9), Draw(0, 9)), InputRect);
		Run(Extent, [&](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
			{ AddShow<FScreenPassVS>(GraphBuilder, Texture, Output, Input); });
		std::vector<FLinearColor> Engines;
		for (int32 i = 0; i < Extent.X * Extent.Y; ++i)
		{
			Engines.push_back(GetPixel(i % Extent.X, i / Extent.X));
		}
		Run(Extent, [&](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
			{ AddShow<FOwnScreenVS>(GraphBuilder, Texture, Output, Input); });
		EXPECT_TRUE(Notes.empty()) << Notes[0].ToString();
		for (int32 i = 0; i < Extent.X * Extent.Y; ++i)
		{
			const int32 X = i % Extent.X;
			const int32 Y = i / Extent.X;
			const bool bInside = X >= Output.Min.X && X < Output.Max.X && Y >= Output.Min.Y && Y < Output.Max.Y;
			const FLinearColor Expected = Engines[size_t(i)];
			const FLinearColor Found = GetPixel(X, Y);
			ASSERT_EQ(bInside, Found != GUntouched) << X << ", " << Y << ", round " << Round;
			const double SlopeU = double(InputRect.Width()) / Input.Extent.X / Output.Width();
			ASSERT_NEAR(Expected.R, Found.R, GetBound(SlopeU, X));
			ASSERT_NEAR(Expected.G, Found.G, GetBound(0, X));
			ASSERT_NEAR(Expected.B, Found.B, GetBound(2.0 / Output.Width(), X));
			ASSERT_NEAR(Expected.A, Found.A, GetBound(0, X));
		}
	}
}

TEST_F(OwnVertexShader, FullscreenDrawsCoverTheViewportOnce)
{
	const FIntPoint Extent(37, 23);
	for (void (*const Draw)(FRHICommandList&, uint32) :
		{&FPixelShaderUtils::DrawFullscreenTriangle, &FPixelShaderUtils::DrawFullscreenQuad})
	{
		Run(Extent,
			[Draw](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
			{
				AddRawShow<FOwnSquareVS>(GraphBuilder, Texture, GFilterVertexDeclaration.VertexDeclarationRHI,
					[Draw](FRHICommandList& RHICmdList)
					{
						RHICmdList.SetViewport(5, 2, 0, 30, 19, 1);
						Draw(RHICmdList, 1);
					});
			});
		EXPECT_TRUE(Notes.empty());
		for (int32 i = 0; i < Extent.X * Extent.Y; ++i)
		{
			const int32 X = i % Extent.X;
			const int32 Y = i / Extent.X;
			const FLinearColor Found = GetPixel(X, Y);
			ASSERT_EQ(X >= 5 && X < 30 && Y >= 2 && Y < 19, Found != GUntouched) << X << ", " << Y;
			if (Found != GUntouched)
			{
				ASSERT_NEAR((X + 0.5 - 5) / 25, Found.R, GetBound(1.0 / 25, X));
				ASSERT_NEAR((Y + 0.5 - 2) / 17, Found.G, GetBound(0, X));
			}
		}
	}
}

TEST_F(OwnVertexShader, DrawRectangleLiesInTheViewport)
{
	const FIntPoint Extent(97, 61);
	Run(Extent,
		[](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
		{
			AddRawShow<FOwnScreenVS>(GraphBuilder, Texture, GFilterVertexDeclaration.VertexDeclarationRHI,
				[](FRHICommandList& RHICmdList)
				{
					RHICmdList.SetViewport(5, 7, 0, 70, 52, 1);
					DrawRectangle(RHICmdList, 3, 4, 31, 17, 2, 1, 10, 5, FIntPoint(65, 45), FIntPoint(20, 13),
						Get<FOwnScreenVS>());
				});
		});
	EXPECT_TRUE(Notes.empty());
	for (int32 Y = 0; Y < Extent.Y; ++Y)
	{
		for (int32 X = 0; X < Extent.X; ++X)
		{
			const bool bInside = X >= 5 + 3 && X < 5 + 3 + 31 && Y >= 7 + 4 && Y < 7 + 4 + 17;
			const FLinearColor Found = GetPixel(X, Y);
			ASSERT_EQ(bInside, Found != GUntouched) << X << ", " << Y;
			if (bInside)
			{
				ASSERT_NEAR((2 + 10 * (X + 0.5 - 8) / 31) / 20, Found.R, GetBound(10.0 / 31 / 20, X));
				ASSERT_NEAR((1 + 5 * (Y + 0.5 - 11) / 17) / 13, Found.G, GetBound(0, X));
				ASSERT_NEAR(2 * (X + 0.5 - 5) / 65 - 1, Found.B, GetBound(2.0 / 65, X));
				ASSERT_NEAR(1 - 2 * (Y + 0.5 - 7) / 45, Found.A, GetBound(0, X));
			}
		}
	}
}

TEST_F(OwnVertexShader, DrawRectangleWithTheEnginesLiesWhereTheTargetSizePutsIt)
{
	std::mt19937 Random(303);
	const auto Draw = [&Random](int32 Low, int32 High)
	{
		return std::uniform_int_distribution<int32>(Low, High)(Random);
	};
	int32 NumInside = 0;
	for (int32 Round = 0; Round < 400; ++Round)
	{
		const FIntPoint Extent(Draw(1, 90), Draw(1, 70));
		const FIntPoint Min(Draw(0, Extent.X - 1), Draw(0, Extent.Y - 1));
		const FIntRect View(Min, Min + FIntPoint(Draw(1, Extent.X - Min.X), Draw(1, Extent.Y - Min.Y)));
		// Pixels of the viewport one to one, or stretched over it.
		const FIntPoint Target = Round % 2 ? View.Size() : FIntPoint(Draw(1, 200), Draw(1, 200));
		const FIntPoint Texture(Draw(1, 300), Draw(1, 300));
		const double Quarter = Round % 3 ? 4 : 1; // at whole pixels, or not
		const double X = Draw(-20, 80) / Quarter, Y = Draw(-20, 80) / Quarter;
		const double SizeX = Draw(1, 300) / Quarter, SizeY = Draw(1, 300) / Quarter;
		const double U = Draw(0, 50), V = Draw(0, 50), SizeU = Draw(1, 100), SizeV = Draw(1, 100);
		Run(Extent,
			[&](FRDGBuilder& GraphBuilder, FRDGTextureRef TargetTexture)
			{
				AddRawShow<FScreenPassVS>(GraphBuilder, TargetTexture, GFilterVertexDeclaration.VertexDeclarationRHI,
					[=](FRHICommandList& RHICmdList)
					{
						RHICmdList.SetViewport(
							float(View.Min.X), float(View.Min.Y), 0, float(View.Max.X), float(View.Max.Y), 1);
						DrawRectangle(RHICmdList, float(X), float(Y), float(SizeX), float(SizeY), float(U), float(V),
							float(SizeU), float(SizeV), Target, Texture, Get<FScreenPassVS>());
					});
			});
		EXPECT_TRUE(Notes.empty()) << Notes[0].ToString();
		const double ScaleX = double(View.Width()) / Target.X, ScaleY = double(View.Height()) / Target.Y;
		const double Left = View.Min.X + X * ScaleX, Right = View.Min.X + (X + SizeX) * ScaleX;
		const double Top = View.Min.Y + Y * ScaleY, Bottom = View.Min.Y + (Y + SizeY) * ScaleY;
		if (Right - Left < 0.5 || Bottom - Top < 0.5)
		{
			continue; // a step of 1/256 pixel would be no small part of it
		}
		const auto IsBeside = [](double Edge, double Centre)
		{
			return std::abs(Edge - Centre) < 1.0 / 200; // which an edge in steps of 1/256 may decide either way
		};
		for (int32 i = 0; i < Extent.X * Extent.Y; ++i)
		{
			const double AtX = i % Extent.X + 0.5, AtY = i / Extent.X + 0.5;
			if (IsBeside(Left, AtX) || IsBeside(Right, AtX) || IsBeside(Top, AtY) || IsBeside(Bottom, AtY))
			{
				continue;
			}
			const bool bInView = AtX > View.Min.X && AtX < View.Max.X && AtY > View.Min.Y && AtY < View.Max.Y;
			const bool bInside = bInView && AtX > Left && AtX < Right && AtY > Top && AtY < Bottom;
			const FLinearColor Found = GetPixel(i % Extent.X, i / Extent.X);
			ASSERT_EQ(bInside, Found != GUntouched) << AtX << ", " << AtY << ", round " << Round;
			if (bInside)
			{
				// Edges in steps of 1/256 pixel move what runs over the rectangle by as much.
				const double PartX = 1.0 / 256 / (Right - Left), PartY = 1.0 / 256 / (Bottom - Top);
				ASSERT_NEAR(
					(U + SizeU * (AtX - Left) / (Right - Left)) / Texture.X, Found.R, SizeU / Texture.X * PartX + 1e-5);
				ASSERT_NEAR(
					(V + SizeV * (AtY - Top) / (Bottom - Top)) / Texture.Y, Found.G, SizeV / Texture.Y * PartY + 1e-5);
				ASSERT_NEAR(2 * (AtX - View.Min.X) / View.Width() - 1, Found.B, 2 * SizeX / Target.X * PartX + 1e-5);
				ASSERT_NEAR(1 - 2 * (AtY - View.Min.Y) / View.Height(), Found.A, 2 * SizeY / Target.Y * PartY + 1e-5);
				++NumInside;
			}
		}
	}
	EXPECT_GT(NumInside, 10000);
}

TEST_F(OwnVertexShader, TapsComputedPerVertexReachThePixels)
{
	const FIntPoint Size(23, 17);
	const FVector2f TapOffset(1.25f, -0.75f);
	std::mt19937 Random(1);
	std::uniform_real_distribution<float> Values(0.0f, 1.0f);
	std::vector<FLinearColor> Colors;
	for (int32 i = 0; i < Size.X * Size.Y; ++i)
	{
		Colors.emplace_back(Values(Random), Values(Random), Values(Random), Values(Random));
	}
	const FIntPoint Extent(40, 30);
	const FIntRect Output(3, 2, 36, 27);
	Run(Extent,
		[&](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
		{
			auto* Parameters = GraphBuilder.AllocParameters<FOwnKawaseParameters>();
			Parameters->TapOffset = TapOffset;
			Parameters->InvTextureSize = FVector2f(1.0f / float(Size.X), 1.0f / float(Size.Y));
			Parameters->InputTexture = AddNoise(GraphBuilder, Colors, Size);
			Parameters->InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp>::GetRHI();
			Parameters->RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::ELoad);
			const FScreenPassPipelineState State(Get<FOwnKawaseVS>(), Get<FOwnKawasePS>());
			AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Kawase"), FScreenPassViewInfo(),
				FScreenPassTextureViewport(Texture, Output), FScreenPassTextureViewport(Parameters->InputTexture),
				State, Parameters,
				[Parameters](FRHICommandList& RHICmdList)
				{
					SetShaderParameters(
						RHICmdList, Get<FOwnKawaseVS>(), Get<FOwnKawaseVS>().GetVertexShader(), *Parameters);
					SetShaderParameters(
						RHICmdList, Get<FOwnKawasePS>(), Get<FOwnKawasePS>().GetPixelShader(), *Parameters);
				});
		});
	EXPECT_TRUE(Notes.empty());
	for (int32 Y = Output.Min.Y; Y < Output.Max.Y; ++Y)
	{
		for (int32 X = Output.Min.X; X < Output.Max.X; ++X)
		{
			const double U = (X + 0.5 - Output.Min.X) / Output.Width() * Size.X;
			const double V = (Y + 0.5 - Output.Min.Y) / Output.Height() * Size.Y;
			FLinearColor Expected(0, 0, 0, 0);
			for (int32 i = 0; i < 4; ++i)
			{
				Expected += SampleBilinear(
								Colors, Size, U + TapOffset.X * (i % 2 ? 1 : -1), V + TapOffset.Y * (i / 2 ? 1 : -1)) *
							0.25f;
			}
			const FLinearColor Found = GetPixel(X, Y);
			// A tap that lies between two steps of 1/256 texel may fall to either, in both directions.
			ASSERT_NEAR(Expected.R, Found.R, 2.0 / 256) << X << ", " << Y;
			ASSERT_NEAR(Expected.A, Found.A, 2.0 / 256) << X << ", " << Y;
		}
	}
}

TEST_F(OwnVertexShader, ATriangleFromVertexNumbersCoversTheViewport)
{
	const FIntPoint Extent(31, 21);
	Run(Extent,
		[](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
		{
			AddRawShow<FOwnTriangleVS>(GraphBuilder, Texture, GEmptyVertexDeclaration.VertexDeclarationRHI,
				[](FRHICommandList& RHICmdList)
				{
					RHICmdList.SetViewport(4, 3, 0, 27, 20, 1);
					RHICmdList.SetScissorRect(true, 6, 0, 31, 18);
					RHICmdList.DrawPrimitive(0, 1, 1);
				});
		});
	EXPECT_TRUE(Notes.empty());
	for (int32 Y = 0; Y < Extent.Y; ++Y)
	{
		for (int32 X = 0; X < Extent.X; ++X)
		{
			const FLinearColor Found = GetPixel(X, Y);
			const bool bInside = X >= 6 && X < 27 && Y >= 3 && Y < 18;
			ASSERT_EQ(bInside, Found != GUntouched) << X << ", " << Y;
			if (bInside)
			{
				ASSERT_NEAR((X + 0.5 - 4) / 23, Found.R, GetBound(1.0 / 23, X));
				ASSERT_NEAR((Y + 0.5 - 3) / 17, Found.G, GetBound(0, X));
				ASSERT_EQ(0, Found.B);
				ASSERT_EQ(7, Found.A);
			}
		}
	}
}

TEST_F(OwnVertexShader, AMeshIsAWarningOfItsPass)
{
	Run(FIntPoint(8, 8),
		[](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
		{
			AddRawShow<FOwnMeshVS>(GraphBuilder, Texture, GFilterVertexDeclaration.VertexDeclarationRHI,
				[](FRHICommandList& RHICmdList)
				{
					RHICmdList.SetStreamSource(0, GScreenRectangleVertexBuffer.VertexBufferRHI, 0);
					RHICmdList.DrawIndexedPrimitive(GScreenRectangleIndexBuffer.IndexBufferRHI, 0, 0, 4, 0, 2, 1);
				});
		});
	EXPECT_EQ(GUntouched, GetPixel(5, 2));
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(2130, Notes[0].Code);
	EXPECT_EQ("pass RawShow", Notes[0].Where);
	EXPECT_THAT(Notes[0].Message, testing::HasSubstr("nothing is drawn with vertex shader FOwnMeshVS"));
	EXPECT_THAT(Notes[0].Message, testing::HasSubstr("perspective"));
}

TEST_F(OwnVertexShader, WithoutItsParametersOrItsRectangleIsAnError)
{
	const auto ErrorOf = [this](const std::function<void(FRDGBuilder&, FRDGTextureRef)>& AddPass) -> std::string
	{
		try
		{
			Run(FIntPoint(8, 8), AddPass);
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitUsage, Error.GetExitCode());
			return Error.what();
		}
		return {};
	};
	const std::string NoParameters = ErrorOf([](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
		{ AddShow<FOwnKawaseVS>(GraphBuilder, Texture, FIntRect(0, 0, 8, 8), FScreenPassTextureViewport(Texture)); });
	EXPECT_THAT(NoParameters, testing::HasSubstr("DD2131"));
	EXPECT_THAT(NoParameters, testing::HasSubstr("pass Show"));
	EXPECT_THAT(NoParameters, testing::HasSubstr("vertex shader FOwnKawaseVS reads '"));
	EXPECT_THAT(NoParameters, testing::HasSubstr("call SetShaderParameters for it"));
	const std::string NoRectangle = ErrorOf(
		[](FRDGBuilder& GraphBuilder, FRDGTextureRef Texture)
		{
			AddRawShow<FOwnScreenVS>(GraphBuilder, Texture, GFilterVertexDeclaration.VertexDeclarationRHI,
				[](FRHICommandList& RHICmdList) { RHICmdList.DrawPrimitive(0, 2, 1); });
		});
	EXPECT_THAT(NoRectangle, testing::HasSubstr("FOwnScreenVS calls DrawRectangle of Common.ush"));
}
