// The OpenGL 4.5 functions that csgscope calls, as one table per context. EGL, OSMesa and windows fill the same table.
#pragma once

#include <GL/glcorearb.h>

#include <functional>

namespace gl {

// A list by macro, since each entry gives a member, its type and its name as a string.
// clang-format off
#define CSGSCOPE_GL_FUNCTIONS(X) \
    X(PFNGLATTACHSHADERPROC, AttachShader) \
    X(PFNGLBEGINQUERYPROC, BeginQuery) \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase) \
    X(PFNGLBINDBUFFERPROC, BindBuffer) \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer) \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture) \
    X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit) \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray) \
    X(PFNGLBLENDEQUATIONPROC, BlendEquation) \
    X(PFNGLBLENDFUNCPROC, BlendFunc) \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate) \
    X(PFNGLBLITNAMEDFRAMEBUFFERPROC, BlitNamedFramebuffer) \
    X(PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC, CheckNamedFramebufferStatus) \
    X(PFNGLCLEARNAMEDBUFFERDATAPROC, ClearNamedBufferData) \
    X(PFNGLCLEARNAMEDFRAMEBUFFERFVPROC, ClearNamedFramebufferfv) \
    X(PFNGLCLEARNAMEDFRAMEBUFFERUIVPROC, ClearNamedFramebufferuiv) \
    X(PFNGLCLEARTEXIMAGEPROC, ClearTexImage) \
    X(PFNGLCLEARTEXSUBIMAGEPROC, ClearTexSubImage) \
    X(PFNGLCLIPCONTROLPROC, ClipControl) \
    X(PFNGLCOLORMASKPROC, ColorMask) \
    X(PFNGLCOMPILESHADERPROC, CompileShader) \
    X(PFNGLCOPYIMAGESUBDATAPROC, CopyImageSubData) \
    X(PFNGLCREATEBUFFERSPROC, CreateBuffers) \
    X(PFNGLCREATEFRAMEBUFFERSPROC, CreateFramebuffers) \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram) \
    X(PFNGLCREATEQUERIESPROC, CreateQueries) \
    X(PFNGLCREATESHADERPROC, CreateShader) \
    X(PFNGLCREATETEXTURESPROC, CreateTextures) \
    X(PFNGLCREATEVERTEXARRAYSPROC, CreateVertexArrays) \
    X(PFNGLCULLFACEPROC, CullFace) \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers) \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers) \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram) \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries) \
    X(PFNGLDELETESHADERPROC, DeleteShader) \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures) \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays) \
    X(PFNGLDEPTHFUNCPROC, DepthFunc) \
    X(PFNGLDEPTHMASKPROC, DepthMask) \
    X(PFNGLDISABLEPROC, Disable) \
    X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute) \
    X(PFNGLDRAWARRAYSPROC, DrawArrays) \
    X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced) \
    X(PFNGLENABLEPROC, Enable) \
    X(PFNGLENABLEVERTEXARRAYATTRIBPROC, EnableVertexArrayAttrib) \
    X(PFNGLENDQUERYPROC, EndQuery) \
    X(PFNGLFINISHPROC, Finish) \
    X(PFNGLFRONTFACEPROC, FrontFace) \
    X(PFNGLGETERRORPROC, GetError) \
    X(PFNGLGETINTEGERVPROC, GetIntegerv) \
    X(PFNGLGETNAMEDBUFFERSUBDATAPROC, GetNamedBufferSubData) \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog) \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv) \
    X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v) \
    X(PFNGLGETQUERYOBJECTUIVPROC, GetQueryObjectuiv) \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog) \
    X(PFNGLGETSHADERIVPROC, GetShaderiv) \
    X(PFNGLGETSTRINGPROC, GetString) \
    X(PFNGLGETTEXTUREIMAGEPROC, GetTextureImage) \
    X(PFNGLGETTEXTURESUBIMAGEPROC, GetTextureSubImage) \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation) \
    X(PFNGLLINKPROGRAMPROC, LinkProgram) \
    X(PFNGLMEMORYBARRIERPROC, MemoryBarrier) \
    X(PFNGLMULTIDRAWARRAYSINDIRECTPROC, MultiDrawArraysIndirect) \
    X(PFNGLNAMEDBUFFERDATAPROC, NamedBufferData) \
    X(PFNGLNAMEDBUFFERSUBDATAPROC, NamedBufferSubData) \
    X(PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC, NamedFramebufferDrawBuffers) \
    X(PFNGLNAMEDFRAMEBUFFERTEXTURELAYERPROC, NamedFramebufferTextureLayer) \
    X(PFNGLNAMEDFRAMEBUFFERTEXTUREPROC, NamedFramebufferTexture) \
    X(PFNGLPIXELSTOREIPROC, PixelStorei) \
    X(PFNGLPROGRAMUNIFORM1FPROC, ProgramUniform1f) \
    X(PFNGLPROGRAMUNIFORM1IPROC, ProgramUniform1i) \
    X(PFNGLPROGRAMUNIFORM1UIPROC, ProgramUniform1ui) \
    X(PFNGLPROGRAMUNIFORM2FVPROC, ProgramUniform2fv) \
    X(PFNGLPROGRAMUNIFORM2IVPROC, ProgramUniform2iv) \
    X(PFNGLPROGRAMUNIFORM3FVPROC, ProgramUniform3fv) \
    X(PFNGLPROGRAMUNIFORM4FVPROC, ProgramUniform4fv) \
    X(PFNGLPROGRAMUNIFORMMATRIX4FVPROC, ProgramUniformMatrix4fv) \
    X(PFNGLREADPIXELSPROC, ReadPixels) \
    X(PFNGLSCISSORPROC, Scissor) \
    X(PFNGLSHADERSOURCEPROC, ShaderSource) \
    X(PFNGLTEXTUREBARRIERPROC, TextureBarrier) \
    X(PFNGLTEXTUREBUFFERPROC, TextureBuffer) \
    X(PFNGLTEXTUREPARAMETERFVPROC, TextureParameterfv) \
    X(PFNGLTEXTUREPARAMETERIPROC, TextureParameteri) \
    X(PFNGLTEXTURESTORAGE2DPROC, TextureStorage2D) \
    X(PFNGLTEXTURESTORAGE3DPROC, TextureStorage3D) \
    X(PFNGLTEXTURESUBIMAGE2DPROC, TextureSubImage2D) \
    X(PFNGLTEXTURESUBIMAGE3DPROC, TextureSubImage3D) \
    X(PFNGLUSEPROGRAMPROC, UseProgram) \
    X(PFNGLVERTEXARRAYATTRIBBINDINGPROC, VertexArrayAttribBinding) \
    X(PFNGLVERTEXARRAYATTRIBFORMATPROC, VertexArrayAttribFormat) \
    X(PFNGLVERTEXARRAYATTRIBIFORMATPROC, VertexArrayAttribIFormat) \
    X(PFNGLVERTEXARRAYBINDINGDIVISORPROC, VertexArrayBindingDivisor) \
    X(PFNGLVERTEXARRAYELEMENTBUFFERPROC, VertexArrayElementBuffer) \
    X(PFNGLVERTEXARRAYVERTEXBUFFERPROC, VertexArrayVertexBuffer) \
    X(PFNGLVIEWPORTPROC, Viewport)
// clang-format on

/// Finds an OpenGL function by its full name ("glDrawArrays"); null where there is none.
using SymbolLoader = std::function<void*(const char* name)>;

/// The table. Members are named as in OpenGL, without the prefix: `gl.DrawArrays(...)`. A context must be current in
/// the calling thread.
struct Functions {
#define CSGSCOPE_GL_MEMBER(type, name) type name = nullptr;
    CSGSCOPE_GL_FUNCTIONS(CSGSCOPE_GL_MEMBER)
#undef CSGSCOPE_GL_MEMBER

    /// Fills the table; throws gl::Error naming the first function that is missing.
    static Functions load(const SymbolLoader& loader);
};

}  // namespace gl
