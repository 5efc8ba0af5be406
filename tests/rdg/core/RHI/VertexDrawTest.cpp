// A vertex shader gets the vertices that buffers, declaration and draw say, and its rectangles are drawn; what it
// misses is a message.
#include <gmock/gmock.h>

#include "CommonRenderResources.h"
#include "RHITestHelpers.h"
#include "VertexRectangles.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

void WriteInterpolants(const FKernelArgs& Args, const FKernelTile& Tile)
{
	for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
	{
		for (int32 X = Tile.MinX; X < Tile.MaxX; ++X)
		{
			for (int32 Channel = 0; Channel < 4; ++Channel)
			{
				const FKernelInterpolant& In = Args.Interpolants[0];
				GetFloats(Args.Targets[0].Texture, X, Y)[Channel] +=
					float(In.Base[Channel] + In.DX[Channel] * (X + 0.5) + In.DY[Channel] * (Y + 0.5));
			}
		}
	}
}

/** A vertex shader in C++: clip position from ATTRIBUTE0.xy, TEXCOORD0 from ATTRIBUTE1; records what it was given. */
class FRecorder final : public FVertexProgram
{
public:
	FVertexOutput Run(const FKernelArgs&, const FVertexInput& Input) const override
	{
		Inputs.push_back(Input);
		FVertexOutput Output;
		Output.Position[0] = float(Input.Attributes[0][0]) + Shift * float(Input.InstanceId);
		Output.Position[1] = float(Input.Attributes[0][1]);
		Output.Position[3] = 1;
		for (int32 i = 0; i < 4; ++i)
		{
			Output.TexCoords[0][i] = float(Input.Attributes[1][i]);
		}
		for (int32 i = GFirstNamedInterpolant; i < GMaxInterpolants; ++i)
		{
			Output.TexCoords[i][0] = 100 * i;
		}
		return Output;
	}
	uint32_t GetAttributesRead() const override { return Attributes; }
	uint32_t GetTexCoordsWritten() const override { return 1 | 7u << GFirstNamedInterpolant; }

	mutable std::vector<FVertexInput> Inputs;
	uint32_t Attributes = 3;
	float Shift = 0;
};

struct FVertex
{
	float Position[2];
	float Value;
	uint8 Color[4];
};

class VertexDraw : public testing::Test
{
protected:
	VertexDraw()
	{
		RHICmdList.BeginRenderPass(FRHIRenderPassInfo(Texture, ERenderTargetActions::Load_Store), TEXT("T"));
	}

	void Bind(EPrimitiveType PrimitiveType, FRHIVertexDeclaration* Declaration)
	{
		FGraphicsPipelineStateInitializer Initializer;
		Initializer.PrimitiveType = PrimitiveType;
		Initializer.BoundShaderState.VertexDeclarationRHI = Declaration;
		// Never looked into: parameters are bound below.
		static int32 NoShader;
		Initializer.BoundShaderState.VertexShaderRHI = VertexShader =
			new FRHIVertexShader(reinterpret_cast<FShader*>(&NoShader));
		SetGraphicsPipelineState(RHICmdList, Initializer);
		RHICmdList.SetBoundPixelShader(MakeShader(EShaderStage::Pixel, WriteInterpolants));
		FBoundShader Bound = MakeShader(EShaderStage::Vertex, nullptr);
		Bound.Vertex = Recorder;
		RHICmdList.SetBoundVertexShader(std::move(Bound));
	}

	FRHIVertexDeclaration* DeclareVertices()
	{
		Declaration = RHICreateVertexDeclaration(
			{FVertexElement(0, 0, VET_Float2, 0, sizeof(FVertex)), FVertexElement(0, 8, VET_Float1, 1, sizeof(FVertex)),
				FVertexElement(0, 12, VET_UByte4N, 2, sizeof(FVertex))});
		return Declaration;
	}

	template<typename T>
	static FBufferRHIRef MakeBuffer(const std::vector<T>& Elements, EBufferUsageFlags Usage)
	{
		const FBufferRHIRef Buffer =
			new FRHIBuffer(FRHIBufferDesc(uint32(Elements.size() * sizeof(T)), sizeof(T), Usage), TEXT("Test"));
		Buffer->EnsureMemory();
		std::memcpy(Buffer->GetData(), Elements.data(), Elements.size() * sizeof(T));
		return Buffer;
	}

	/** Corners of clip space as a strip, after one vertex that is not meant; value 1 + index. */
	static std::vector<FVertex> MakeCorners()
	{
		return {{{9, 9}, 9, {}}, {{-1, 1}, 1, {255, 0, 51, 0}}, {{1, 1}, 2, {}}, {{-1, -1}, 3, {}}, {{1, -1}, 4, {}}};
	}

	std::string ErrorOf(const std::function<void()>& Work)
	{
		try
		{
			Work();
		}
		catch (const FError& Error)
		{
			return Error.what();
		}
		return {};
	}

	FTextureRHIRef Texture = MakeTexture(FIntPoint(8, 4), PF_A32B32G32R32F);
	FRHICommandListImmediate RHICmdList;
	std::shared_ptr<FRecorder> Recorder = std::make_shared<FRecorder>();
	FVertexDeclarationRHIRef Declaration;
	FVertexShaderRHIRef VertexShader;
};

} // namespace

TEST_F(VertexDraw, VerticesComeFromTheStreamByTheDeclaration)
{
	Recorder->Attributes = 7;
	Bind(PT_TriangleStrip, DeclareVertices());
	RHICmdList.SetStreamSource(0, MakeBuffer(MakeCorners(), BUF_VertexBuffer), 0);
	RHICmdList.DrawPrimitive(1, 2, 1);
	ASSERT_EQ(4u, Recorder->Inputs.size()) << "each vertex once";
	EXPECT_EQ(0u, Recorder->Inputs[0].VertexId) << "without the base, as Direct3D counts";
	EXPECT_EQ(-1, Recorder->Inputs[0].Attributes[0][0]);
	EXPECT_EQ(1, Recorder->Inputs[0].Attributes[0][1]);
	EXPECT_EQ(0, Recorder->Inputs[0].Attributes[0][2]);
	EXPECT_EQ(1, Recorder->Inputs[0].Attributes[0][3]);
	EXPECT_EQ(1, Recorder->Inputs[0].Attributes[2][0]);
	EXPECT_EQ(51 / 255.0, Recorder->Inputs[0].Attributes[2][2]);
	// 1 .. 2 to the right, 1 .. 3 downwards.
	for (int32 Y = 0; Y < 4; ++Y)
	{
		for (int32 X = 0; X < 8; ++X)
		{
			EXPECT_NEAR(1 + (X + 0.5) / 8 + 2 * (Y + 0.5) / 4, Texture->ReadTexel(X, Y).R, 1e-6);
		}
	}
}

TEST_F(VertexDraw, IndicesOfBothWidthsAndABaseChooseTheVertices)
{
	for (const bool bWide : {false, true})
	{
		Texture->Fill(FLinearColor(0, 0, 0, 0));
		Bind(PT_TriangleList, DeclareVertices());
		RHICmdList.SetStreamSource(0, MakeBuffer(MakeCorners(), BUF_VertexBuffer), sizeof(FVertex));
		const FBufferRHIRef Indices =
			bWide ? MakeBuffer(std::vector<uint32>{7, 2, 3, 5, 5, 4, 2}, EBufferUsageFlags::IndexBuffer)
				  : MakeBuffer(std::vector<uint16>{7, 2, 3, 5, 5, 4, 2}, EBufferUsageFlags::IndexBuffer);
		// Index 2 is vertex 0 of the stream that begins with the second; 5 is the last.
		RHICmdList.DrawIndexedPrimitive(Indices, -2, 0, 4, 1, 2, 1);
		EXPECT_NEAR(1 + 7.5 / 8 + 2 * 3.5 / 4, Texture->ReadTexel(7, 3).R, 1e-6) << bWide;
	}
}

TEST_F(VertexDraw, EveryInstanceHasItsRectangle)
{
	Recorder->Shift = 1; // half a viewport to the right, the rest is cut off
	Bind(PT_TriangleStrip, DeclareVertices());
	RHICmdList.SetStreamSource(0, MakeBuffer(MakeCorners(), BUF_VertexBuffer), sizeof(FVertex));
	RHICmdList.DrawPrimitive(0, 2, 2);
	const double First = 1 + 4.5 / 8 + 2 * 0.5 / 4;
	const double Second = 1 + 0.5 / 8 + 2 * 0.5 / 4;
	EXPECT_NEAR(Second, Texture->ReadTexel(0, 0).R, 1e-6) << "the first alone";
	EXPECT_NEAR(First + Second, Texture->ReadTexel(4, 0).R, 1e-6) << "both, added up";
	EXPECT_EQ(1u, Recorder->Inputs[4].InstanceId);
}

TEST_F(VertexDraw, TheEnginesBuffersAreARectangleEach)
{
	// Corners of the unit square: the right upper quarter of clip space. Counted before the render target's edge.
	Bind(PT_TriangleList, GFilterVertexDeclaration.VertexDeclarationRHI);
	RHICmdList.SetStreamSource(0, GScreenRectangleVertexBuffer.VertexBufferRHI, 0);
	RHICmdList.DrawIndexedPrimitive(GScreenRectangleIndexBuffer.IndexBufferRHI, 0, 0, 4, 0, 2, 1);
	EXPECT_EQ(0, Texture->ReadTexel(3, 0).A);
	EXPECT_EQ(0, Texture->ReadTexel(4, 2).A);
	EXPECT_NEAR(0.5 / 4, Texture->ReadTexel(4, 1).R, 1e-7) << "UV of the unit square";
	EXPECT_NEAR(1 - 0.5 / 2, Texture->ReadTexel(7, 0).G, 1e-7) << "whose y runs upwards in clip space";

	Recorder->Attributes = 1;
	Texture->Fill(FLinearColor(0, 0, 0, 0));
	Bind(PT_TriangleList, GTileVertexDeclaration.VertexDeclarationRHI);
	RHICmdList.SetStreamSource(0, GScreenSpaceVertexBuffer.VertexBufferRHI, 0);
	RHICmdList.DrawIndexedPrimitive(GTwoTrianglesIndexBuffer.IndexBufferRHI, 0, 0, 4, 0, 2, 1);
	EXPECT_TRUE(RHICmdList.GetCounters().Remarks.empty());
	EXPECT_EQ(8u + 32u, RHICmdList.GetCounters().Pixels);
}

TEST_F(VertexDraw, BeyondABufferIsZero)
{
	Bind(PT_TriangleList, DeclareVertices());
	RHICmdList.SetStreamSource(0, MakeBuffer(MakeCorners(), BUF_VertexBuffer), 0);
	RHICmdList.DrawPrimitive(4, 1, 1);
	EXPECT_EQ(0, Recorder->Inputs.at(1).Attributes[0][0]);
	EXPECT_EQ(0, Recorder->Inputs.at(1).Attributes[0][3]);
}

TEST_F(VertexDraw, WhatIsMissingIsAMessage)
{
	const auto Draw = [this]
	{
		RHICmdList.DrawPrimitive(0, 2, 1);
	};
	Bind(PT_TriangleStrip, nullptr);
	EXPECT_THAT(ErrorOf(Draw), testing::HasSubstr("DD2131"));
	EXPECT_THAT(
		ErrorOf(Draw), testing::HasSubstr("FTestShader reads ATTRIBUTE0, but the pipeline state has no vertex"));
	Recorder->Attributes = 8;
	Bind(PT_TriangleStrip, DeclareVertices());
	EXPECT_THAT(ErrorOf(Draw), testing::HasSubstr("ATTRIBUTE3, which the vertex declaration"));
	Recorder->Attributes = 1;
	EXPECT_THAT(ErrorOf(Draw), testing::HasSubstr("stream 0 has no buffer: call SetStreamSource"));
	RHICmdList.SetStreamSource(0, MakeBuffer(MakeCorners(), BUF_VertexBuffer), 0);
	EXPECT_THAT(ErrorOf([this] { RHICmdList.DrawIndexedPrimitive(nullptr, 0, 0, 4, 0, 2, 1); }),
		testing::HasSubstr("the index buffer of DrawIndexedPrimitive is null"));

	FBoundShader Pixel = MakeShader(EShaderStage::Pixel, WriteInterpolants);
	FShaderReflection Reflection = Pixel.GetReflection();
	Reflection.NumInterpolants = 3;
	Pixel.Reflection = std::make_shared<const FShaderReflection>(Reflection);
	RHICmdList.SetBoundPixelShader(std::move(Pixel));
	EXPECT_THAT(ErrorOf(Draw), testing::HasSubstr("DD2132"));
	EXPECT_THAT(ErrorOf(Draw), testing::HasSubstr("reads TEXCOORD2, which vertex shader FTestShader does not write"));

	const auto ErrorOfReading = [&](int32 NumInterpolants, uint32 Integers)
	{
		FBoundShader Other = MakeShader(EShaderStage::Pixel, WriteInterpolants);
		Reflection.NumInterpolants = NumInterpolants;
		Reflection.IntegerInterpolants = Integers;
		Other.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		RHICmdList.SetBoundPixelShader(std::move(Other));
		return ErrorOf(Draw);
	};
	EXPECT_THAT(
		ErrorOfReading(1, 1), testing::HasSubstr("reads TEXCOORD0 as integers, which vertex shader FTestShader"));
	EXPECT_THAT(ErrorOfReading(18, 0), testing::HasSubstr("reads COLOR1, which vertex shader FTestShader does not"));
	SetGraphicsPipelineState(RHICmdList, FGraphicsPipelineStateInitializer());
	EXPECT_THAT(ErrorOfReading(17, 0), testing::HasSubstr("reads COLOR0, which vertex shader FScreenPassVS does not"));
	EXPECT_EQ("", ErrorOfReading(16, 0));
}

TEST_F(VertexDraw, SemanticsOfAnyNameMeetByName)
{
	RHICmdList.SetStreamSource(0, MakeBuffer(MakeCorners(), BUF_VertexBuffer), 0);
	Bind(PT_TriangleStrip, DeclareVertices());
	const auto Draw = [&](std::vector<std::string> Read, std::vector<std::string> Written)
	{
		FBoundShader Vertex = MakeShader(EShaderStage::Vertex, nullptr);
		FShaderReflection Reflection = Vertex.GetReflection();
		Reflection.NamedInterpolants = std::move(Written);
		Vertex.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		Vertex.Vertex = Recorder;
		RHICmdList.SetBoundVertexShader(std::move(Vertex));
		FBoundShader Pixel = MakeShader(EShaderStage::Pixel,
			[](const FKernelArgs& Args, const FKernelTile&)
			{
				float* const Texel = GetFloats(Args.Targets[0].Texture, 0, 0);
				Texel[0] = float(Args.Interpolants[GFirstNamedInterpolant + 1].Base[0]);
				Texel[1] = float(Args.Interpolants[GFirstNamedInterpolant + 2].Base[0]);
			});
		Reflection = Pixel.GetReflection();
		Reflection.NamedInterpolants = std::move(Read);
		Reflection.NumInterpolants = GFirstNamedInterpolant + 3;
		Pixel.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		RHICmdList.SetBoundPixelShader(std::move(Pixel));
		return ErrorOf([&] { RHICmdList.DrawPrimitive(1, 2, 1); });
	};
	EXPECT_EQ("", Draw({"", "NORMAL0", "TANGENT1"}, {"BASIS0", "TANGENT1", "NORMAL0"}));
	const float* const Texel = GetFloats(Texture->GetKernelView(0, 1, 0), 0, 0);
	EXPECT_EQ(2200, Texel[0]);
	EXPECT_EQ(2100, Texel[1]);
	EXPECT_THAT(Draw({"", "NORMAL0", "TANGENT1"}, {"NORMAL1", "TANGENT1"}),
		testing::HasSubstr("pixel shader FTestShader reads NORMAL0, which vertex shader FTestShader does not write"));
	SetGraphicsPipelineState(RHICmdList, FGraphicsPipelineStateInitializer());
	FBoundShader Pixel = MakeShader(EShaderStage::Pixel, WriteInterpolants);
	FShaderReflection Reflection = Pixel.GetReflection();
	Reflection.NamedInterpolants = {"NORMAL0"};
	Reflection.NumInterpolants = GFirstNamedInterpolant + 1;
	Pixel.Reflection = std::make_shared<const FShaderReflection>(Reflection);
	RHICmdList.SetBoundPixelShader(std::move(Pixel));
	EXPECT_THAT(ErrorOf([&] { RHICmdList.DrawPrimitive(0, 1, 1); }),
		testing::HasSubstr("reads NORMAL0, which vertex shader FScreenPassVS does not write"));
}

TEST_F(VertexDraw, AnIntegerThatDiffersIsNotDrawn)
{
	FDrawnRectangles Drawn;
	std::vector<FVertexOutput> Vertices(6);
	const float Corners[6][2] = {{-1, 1}, {1, 1}, {-1, -1}, {-1, -1}, {1, 1}, {1, -1}};
	for (int32 i = 0; i < 6; ++i)
	{
		std::copy(Corners[i], Corners[i] + 2, Vertices[size_t(i)].Position);
		Vertices[size_t(i)].Position[3] = 1;
		Vertices[size_t(i)].TexCoords[GMaxTexCoords][0] = 4294967295.0;
	}
	const FIntRect Rect(0, 0, 4, 4);
	Drawn = FindDrawnRectangles(Vertices, Rect, Rect, GMaxTexCoords + 1, 1u << GMaxTexCoords);
	ASSERT_EQ(1u, Drawn.Rectangles.size());
	EXPECT_EQ(4294967295.0, Drawn.Rectangles[0].Interpolants[GMaxTexCoords].Base[0]);
	for (FVertexOutput& Vertex : Vertices)
	{
		Vertex.TexCoords[GMaxTexCoords][0] = double(Vertex.Position[0]);
	}
	EXPECT_EQ("", FindDrawnRectangles(Vertices, Rect, Rect, GMaxTexCoords + 1, 0).Fault);
	EXPECT_EQ("the integers of COLOR0 are not the same at all vertices",
		FindDrawnRectangles(Vertices, Rect, Rect, GMaxTexCoords + 1, 1u << GMaxTexCoords).Fault);
}

TEST_F(VertexDraw, AMeshIsNotDrawnAndSaidOnce)
{
	std::vector<FVertex> Mesh = MakeCorners();
	Mesh[4].Position[0] = std::numeric_limits<float>::quiet_NaN();
	Bind(PT_TriangleStrip, DeclareVertices());
	RHICmdList.SetStreamSource(0, MakeBuffer(Mesh, BUF_VertexBuffer), sizeof(FVertex));
	RHICmdList.DrawPrimitive(0, 2, 1);
	RHICmdList.DrawPrimitive(0, 2, 1);
	EXPECT_EQ(0, Texture->ReadTexel(0, 0).R);
	const std::vector<FDiagnostic>& Remarks = RHICmdList.GetCounters().Remarks;
	ASSERT_EQ(1u, Remarks.size());
	EXPECT_EQ(2130, Remarks[0].Code);
	EXPECT_EQ(ESeverity::Warning, Remarks[0].Severity);
	EXPECT_THAT(Remarks[0].Message, testing::HasSubstr("nothing is drawn with vertex shader FTestShader"));

	RHICmdList.DrawPrimitive(0, 5000, 2);
	ASSERT_EQ(2u, RHICmdList.GetCounters().Remarks.size());
	EXPECT_THAT(
		RHICmdList.GetCounters().Remarks[1].Message, testing::HasSubstr("10000 triangles, and 8192 are the most"));

	// The first pass of a graph begins anew; what was drawn outside of passes is still to be said.
	RHICmdList.ResetCounters();
	EXPECT_EQ(0u, RHICmdList.GetCounters().Pixels);
	EXPECT_EQ(2u, RHICmdList.TakeRemarks().size());
	EXPECT_TRUE(RHICmdList.GetCounters().Remarks.empty());
}
