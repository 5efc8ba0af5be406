// Forward declarations of the RHI's types, for headers that only hold pointers to them. Source: engine RHIFwd.h.
#pragma once

class FRHIResource;
class FRHIViewableResource;
class FRHITexture;
class FRHIBuffer;
class FRHIView;
class FRHIShaderResourceView;
class FRHIUnorderedAccessView;
class FRHISamplerState;
class FRHIBlendState;
class FRHIRasterizerState;
class FRHIDepthStencilState;
class FRHIVertexDeclaration;
class FRHIShader;
class FRHIGraphicsShader;
class FRHIVertexShader;
class FRHIPixelShader;
class FRHIGeometryShader;
class FRHIComputeShader;

class FRHICommandListBase;
class FRHIComputeCommandList;
class FRHICommandList;
class FRHICommandListImmediate;

struct FRHITextureDesc;
struct FRHITextureCreateDesc;
struct FRHICopyTextureInfo;
struct FRHIRenderPassInfo;
struct FGraphicsPipelineStateInitializer;
